// SPDX-License-Identifier: BSD-3-Clause
// Messages about flaws of a surface and its mesh, with places, or nothing.
#pragma once

#include "Base/Error.h"
#include "Boxes/FlowRefinement.h"
#include "Mesher/Mesher.h"

#include <map>

namespace cartesian
{

// Flaws found and repaired. `cells`: the user's number of each triangle given; `names`: of boundaries.
std::string describeFlaws(const PreparedSurface& prepared, const std::vector<Id>& cells,
  const std::map<std::int32_t, std::string>& names);

// Where the surface reaches beyond the meshlines, unless it is what a box around it cuts off.
std::string describeOverhang(const PreparedSurface& prepared);

// If all of the surface is smaller than a cell, as one in another unit is.
std::string describeTiny(const PreparedSurface& prepared, const Options& options);

// If there are fewer boxes along bodies than the user requested.
std::string describeShortfall(const DomainSpec& domain, const FlowRefinement& flow);

// Boxes whose patches were rebuilt, and those that are left out; cells that are left out, whatever the reason, if
// they are more than a thousandth of the volume; cells that overlap. `names`: of boundaries.
std::string describeFlaws(
  const Assembly& assembly, const std::map<std::int32_t, std::string>& names = {});

// Why there is no cell: BadCellSize or FlawedSurface.
Error nothingToMesh(const Assembly& assembly, const Options& options);

}
