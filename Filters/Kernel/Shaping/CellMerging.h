// SPDX-License-Identifier: BSD-3-Clause
// Small cells, and those at fault, become a part of a neighbour (section 4.10, but the volume is kept).
#pragma once

#include "Base/Execution.h"
#include "Shaping/CellComplex.h"

namespace cartesian
{

struct MergeSpec
{
  double ratio = 0; // cells below this part of their box's volume are small

  JoinSpec joins; // which faces of the result become one
};

// Each small cell, or each at fault (CellFaults.h), joins the neighbour with which the sum of all costs
// around it (CellCost.h) falls most; where it falls with none, the cell stays. One after the other, the
// smallest first, within a slab. No two faces get the same nodes. Returns how many were merged.
std::size_t mergeSmallCells(CellComplex& cells, const MergeSpec& spec, Execution& execution);
std::size_t mergeFailingCells(CellComplex& cells, const MergeSpec& spec, Execution& execution);

// The same for cells with a face that costs more than PoorCost: accepted, but better off in one.
std::size_t mergePoorCells(CellComplex& cells, const MergeSpec& spec, Execution& execution);

}
