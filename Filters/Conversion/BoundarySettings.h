// SPDX-License-Identifier: BSD-3-Clause
// What the user says about boundaries by name: the rows of the table Boundaries.
#pragma once

#include "BoundaryNames.h"
#include "Cells/SmallCellSpec.h"
#include "Surface/WallLayerSpec.h"

#include <vector>

namespace cartesian
{

// The type of a boundary for which the user has not chosen one.
constexpr const char* AutomaticType = "automatic";

// The type of a boundary whose triangles are sheets in a region (Repair/Baffles.h).
constexpr const char* BaffleType = "baffle";

struct BoundarySettings
{
  std::vector<std::string> names; // each once
  std::vector<std::string>
    types;                    // foamTypes(), BaffleType or AutomaticType, for each name; or empty
  std::vector<double> ratios; // the R of section 4.10 for each name; or empty
  std::vector<double>
    layers; // how thick all layers are, for each name; negative: as elsewhere; or empty
};

// The R of boundaries that something flows through, where small cells are removed (section 4.10): of type patch,
// or without a type, but of a name that says so (isOpening). There nothing that has a volume is left out.
constexpr double OpeningRatio = 1e-100;

// Types (without AutomaticType) and ratios by the numbers of the boundaries. Both throw Error (BadParameter):
// a name that is unknown or there twice, an unknown type, fewer or more types or ratios than names.
std::map<std::int32_t, std::string> boundaryTypes(
  const BoundarySettings& settings, const BoundaryNames& names);
std::vector<BoundaryRatio> boundaryRatios(
  const BoundarySettings& settings, const BoundaryNames& names, SmallCells handling);

// Boundaries whose layers are unlike the others': the rows with a thickness, then those that are no walls, by type or
// else by name. Throws what boundaryTypes does; fewer or more thicknesses than names.
std::vector<WallLayerSpec::OfBoundary> boundaryLayers(
  const BoundarySettings& settings, const BoundaryNames& names);

}
