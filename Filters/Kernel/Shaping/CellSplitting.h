// SPDX-License-Identifier: BSD-3-Clause
// Cell splitting (section 4.11): cells so concave that an angle condition of section 3 fails are cut
// along their worst concave edges.
#pragma once

#include "Base/Execution.h"
#include "Shaping/CellComplex.h"

namespace cartesian
{

struct Splitting
{
  std::size_t cellsSplit = 0; // that there were before
};

// Cells are cut one by one, the worst first; changed ones again, until no cut is found. So the result depends on the
// cells only. `failing`: cells that fail a condition, in order. No part becomes smaller than `leastFraction` of its
// box.
Splitting splitCells(
  CellComplex& cells, std::vector<CellKey> failing, double leastFraction, Execution& execution);

}
