// SPDX-License-Identifier: BSD-3-Clause
// The part of a cell for which solvers refuse it is cut off and joins another cell (sections 4.10 and 4.11):
// where neither a cut that keeps both parts helps, nor a merge of the whole cell.
#pragma once

#include "Shaping/CellMerging.h"
#include "Shaping/RemovedCell.h"

namespace cartesian
{

// What becomes of a part that no other cell can take so that solvers accept it.
enum class LeftOver : std::uint8_t
{
  ComesBack,
  IsRemoved, // if it lies at the boundary
};

// Of these cells, in order. No part is larger than half of the cell's box. Appends the parts that were removed.
void transferParts(CellComplex& cells, const std::vector<CellKey>& keys, LeftOver leftOver,
  CellMerger& merger, Execution& execution, std::vector<RemovedCell>& removed);

}
