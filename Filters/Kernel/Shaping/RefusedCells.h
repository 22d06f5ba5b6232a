// SPDX-License-Identifier: BSD-3-Clause
// The last resort where neither a cut, nor a merge, nor an IP patch mends a cell (section 4.11): it is
// removed as a small cell is (4.10).
#pragma once

#include "Base/Execution.h"
#include "Shaping/CellComplex.h"
#include "Shaping/RemovedCell.h"

namespace cartesian
{

// Cells go that are smaller than this part of their box.
struct LargestRemoved
{
  double refused; // with faces that solvers refuse (CellFaults.h)
  double invalid; // with a face turned over, or too few
};

// Of these cells, in order: those that solvers refuse; of an inner face's two the smaller goes. Only cells with a
// boundary face go, smaller than `largest`, or than R where their boundary has its own; of neighbours only one, the
// smallest, as that may be enough. Appends what was removed.
void removeRefused(CellComplex& cells, const std::vector<CellKey>& keys, const SmallCellSpec& small,
  const LargestRemoved& largest, Execution& execution, std::vector<RemovedCell>& removed);

// Whether a cell may go: none that the slab must leave as it is would be refused for want of it.
bool sparesOthers(const CellComplex& cells, CellKey key);

// Whether a cell may go without taking wall from all boundaries but one, and what is exposed is about as large as the
// wall that goes.
bool keepsWall(const CellComplex& cells, CellKey key);

// One cell, noted where it counts (CellComplex::counts).
void remove(CellComplex& cells, CellKey key, std::vector<RemovedCell>& removed);

}
