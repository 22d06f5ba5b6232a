// SPDX-License-Identifier: BSD-3-Clause
// Settings of boundaries by name: the rows of the table Boundaries.
#pragma once

#include "BoundaryNames.h"
#include "Cells/SmallCellSpec.h"
#include "Surface/WallLayerSpec.h"
#include "Surface/Walls.h"

#include <set>
#include <vector>

namespace cartesian
{

// The type of a boundary for which the user has not chosen one.
constexpr const char* AutomaticType = "automatic";

// The type of a boundary whose triangles are sheets in a region (Repair/Baffles.h).
constexpr const char* BaffleType = "baffle";

// The type of a boundary that encloses a zone of the domain (Repair/Zones.h).
constexpr const char* ZoneType = "zone";

struct BoundarySettings
{
  // Each for one boundary, or for all that match a pattern with * (any text) or ? (any character) and that no row has
  // by name; of several patterns the first counts. Sides of the domain match no pattern.
  std::vector<std::string> names; // each once
  std::vector<std::string>
    types; // foamTypes(), BaffleType, ZoneType or AutomaticType, for each name; or empty
  std::vector<double>
    ratios; // the R of section 4.10 for each name; negative: as elsewhere; or empty
  std::vector<double>
    layers; // how thick all layers are, for each name; negative: as elsewhere; or empty
  std::vector<int> depths; // of refinement, for each name; negative: as elsewhere; or empty
  std::vector<std::string> mergedNames; // the new name for each name; empty: unchanged; or empty
};

// The new names of boundaries that merge.
BoundaryNames mergedNames(const BoundarySettings& settings, const BoundaryNames& names);

// The rows of boundaries that have merged, each with their new name; of several rows of one name the first counts.
BoundarySettings merged(const BoundarySettings& settings);

// The R of openings, where small cells are removed (section 4.10): of type patch, or without a type but with an
// opening's name (isOpening). There nothing that has a volume is left out.
constexpr double OpeningRatio = 1e-100;

// Types (without AutomaticType), ratios and depths by the numbers of the boundaries, some of which are `sides` of the
// domain. They throw Error (BadParameter): a name that is unknown or present twice, a pattern that only sides match, an
// unknown type, fewer or more of them than names.
std::map<std::int32_t, std::string> boundaryTypes(
  const BoundarySettings& settings, const BoundaryNames& names, const EndBoundaries& sides);
std::vector<BoundaryRatio> boundaryRatios(const BoundarySettings& settings,
  const BoundaryNames& names, const EndBoundaries& sides, SmallCells handling);
std::map<std::int32_t, int> boundaryDepths(
  const BoundarySettings& settings, const BoundaryNames& names, const EndBoundaries& sides);

// Boundaries of BaffleType. Rows that are wrong, or of sides that are added later, are passed over.
std::set<std::int32_t> baffleBoundaries(
  const BoundarySettings& settings, const BoundaryNames& names);

// The numbers of regions (Walls.h) by name. Throws Error (BadParameter) if there is none of a name.
std::vector<std::int32_t> layerRegions(
  const std::vector<std::string>& asked, const std::vector<std::string>& regions);

// Boundaries with their own layers: the rows with a thickness, then those that do not count as walls, by type or else
// by name. Throws what boundaryTypes does; fewer or more thicknesses than names.
std::vector<WallLayerSpec::OfBoundary> boundaryLayers(
  const BoundarySettings& settings, const BoundaryNames& names, const EndBoundaries& sides);

}
