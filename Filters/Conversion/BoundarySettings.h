// SPDX-License-Identifier: BSD-3-Clause
// What the user says of boundaries by name: the rows of the table Boundaries.
#pragma once

#include "BoundaryNames.h"
#include "Cells/SmallCellSpec.h"

#include <vector>

namespace cartesian
{

// The type of a boundary of which the user says nothing.
constexpr const char* AutomaticType = "automatic";

struct BoundarySettings
{
  std::vector<std::string> names; // of different boundaries
  std::vector<std::string> types; // one of foamTypes() or AutomaticType for each name, or none
  std::vector<double> ratios;     // the R of section 4.10 for each name, or none
};

// By the boundaries' numbers; types without those of AutomaticType. Both throw Error (BadParameter): a
// name that is unknown or there twice, an unknown type, not as many types or ratios as names.
std::map<std::int32_t, std::string> boundaryTypes(
  const BoundarySettings& settings, const BoundaryNames& names);
std::vector<BoundaryRatio> boundaryRatios(
  const BoundarySettings& settings, const BoundaryNames& names);

}
