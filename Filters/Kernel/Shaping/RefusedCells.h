// SPDX-License-Identifier: BSD-3-Clause
// The last resort where neither a cut, nor a merge, nor an IP patch mends a cell (section 4.11): it is
// removed as a small cell is (4.10).
#pragma once

#include "Base/Execution.h"
#include "Shaping/CellComplex.h"
#include "Shaping/RemovedCell.h"

namespace cartesian
{

// Of these cells, in order: those with refused faces (CellFaults.h), or too few; of an inner face's two the
// smaller goes. Only cells with a boundary face go, smaller than `largest` volumes of their box, or than R where
// their boundary has its own; of neighbours only one, the smallest, as that may be enough. Appends what was
// removed.
void removeRefused(CellComplex& cells, const std::vector<CellKey>& keys, const SmallCellSpec& small,
  double largest, Execution& execution, std::vector<RemovedCell>& removed);

// Whether a cell may go: none that the slab must leave as it is would be refused for want of it.
bool sparesOthers(const CellComplex& cells, CellKey key);

// One cell, noted where it counts (CellComplex::counts).
void remove(CellComplex& cells, CellKey key, std::vector<RemovedCell>& removed);

}
