// SPDX-License-Identifier: BSD-3-Clause
// Cuts off the part of a cell that makes it fail, and joins it to another cell (sections 4.10 and 4.11), if neither a
// cut that keeps both parts helps, nor a merge of the whole cell.
#pragma once

#include "Shaping/CellMerging.h"
#include "Shaping/RemovedCell.h"

namespace cartesian
{

// Treatment of a part that no other cell can take without failing.
enum class LeftOver : std::uint8_t
{
  ComesBack,
  IsRemoved, // if it lies at the boundary
};

// Of these cells, in order. No part is larger than half of the cell's box. Appends the parts that were removed.
void transferParts(CellComplex& cells, const std::vector<CellKey>& keys, LeftOver leftOver,
  CellMerger& merger, Execution& execution, std::vector<RemovedCell>& removed);

}
