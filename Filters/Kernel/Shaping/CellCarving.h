// SPDX-License-Identifier: BSD-3-Clause
// The part of a cell that makes solvers refuse it is cut off and removed (sections 4.10 and 4.11):
// where the whole cell is too large to go, and no cut helps that keeps both parts.
#pragma once

#include "Base/Execution.h"
#include "Shaping/CellComplex.h"

namespace cartesian
{

// Of these cells, in order. No part cut off is larger than `largest` of the cell's box. Returns how
// many parts were removed.
std::size_t carveCells(
  CellComplex& cells, const std::vector<CellKey>& keys, double largest, Execution& execution);

}
