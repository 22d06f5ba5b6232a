// SPDX-License-Identifier: BSD-3-Clause
// Cells of fewer than four faces, which no solver accepts: what is left between two walls that meet in a box.
#pragma once

#include "Base/Execution.h"
#include "Shaping/CellComplex.h"

namespace cartesian
{

// Each of these that is one joins a neighbour of its region, whatever that costs, that with which it shares most area
// first; or, if it has none, one of the region beyond its only wall, to which it then belongs; or is removed, where it
// is at the boundary alone; one without neighbours stays, as it may be all that there is. Returns how many have gone.
std::size_t mergeFewFaced(
  CellComplex& cells, const std::vector<CellKey>& keys, Execution& execution);

}
