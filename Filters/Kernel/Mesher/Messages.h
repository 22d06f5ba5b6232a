// SPDX-License-Identifier: BSD-3-Clause
// What the user is told about flaws of a surface and its mesh: in words with places, or nothing.
#pragma once

#include "Base/Error.h"
#include "Boxes/FlowRefinement.h"
#include "Mesher/Mesher.h"

#include <map>

namespace cartesian
{

// What was found and repaired. `cells`: the user's number of each triangle given; `names`: of boundaries.
std::string describeFlaws(const PreparedSurface& prepared, const std::vector<Id>& cells,
  const std::map<std::int32_t, std::string>& names);

// Where the surface reaches beyond the meshlines, unless it is what a box around it cuts off.
std::string describeOverhang(const PreparedSurface& prepared);

// Where there are fewer boxes along bodies than the user asks for.
std::string describeShortfall(const DomainSpec& domain, const FlowRefinement& flow);

// Boxes whose patches were made anew, and those that are left out; cells that are left out, whatever the reason, if they
// are more than a thousandth of the volume; cells that stay although solvers may refuse them. `names`: of boundaries.
std::string describeFlaws(
  const Assembly& assembly, const std::map<std::int32_t, std::string>& names = {});

// Why there is no cell: BadCellSize or FlawedSurface.
Error nothingToMesh(const Assembly& assembly, const Options& options);

}
