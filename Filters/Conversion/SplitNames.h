// SPDX-License-Identifier: BSD-3-Clause
// Names for the patches of a divided surface.
#pragma once

#include "BoundaryNames.h"
#include "Surface/SurfaceSplit.h"

#include <string>
#include <vector>

namespace cartesian
{

// The name of each patch, all different. A boundary that is not divided keeps its name. Caps have those of
// `capNames`, which commas separate: the largest cap the first, and so on; those that are left number the last name.
// Other patches have their boundary's name, numbered if they are several. Where the surface's only boundary has no name, they are
// wall, the rest beside caps and planes; plane; or patch.
std::vector<std::string> patchNames(
  const SurfaceSplit& split, const BoundaryNames& names, SplitBy by, const std::string& capNames);

}
