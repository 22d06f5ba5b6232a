// SPDX-License-Identifier: BSD-3-Clause
// Names for the patches of a divided surface.
#pragma once

#include "BoundaryNames.h"
#include "Surface/SurfaceSplit.h"

#include <string>
#include <vector>

namespace cartesian
{

// The name of each patch before numbers tell those of one name apart. A boundary that is not divided keeps its name. Caps have
// those of `capNames`, which commas separate: the largest cap the first, and so on; those that are left have the last name.
// Other patches have their boundary's name. Where the surface's only boundary has no name, they are wall, the rest beside
// caps and planes; plane; or patch.
std::vector<std::string> baseNames(
  const SurfaceSplit& split, const BoundaryNames& names, SplitBy by, const std::string& capNames);

// All different: where several patches have a name, it is numbered, without gaps for those that are gone or a name that is taken.
std::vector<std::string> numbered(const std::vector<std::string>& bases,
  const std::vector<bool>& isGone = {}, const std::string& taken = {});

// Flat caps that a solver would take for walls, by their names; empty: none. `nameOf`: of each patch now.
std::string describeWalledCaps(const SurfaceSplit& split, SplitBy by,
  const std::vector<std::string>& bases, const std::string& capNames,
  const std::vector<std::string>& nameOf);

}
