// SPDX-License-Identifier: BSD-3-Clause
// The last resort if neither a cut, nor a merge, nor an IP patch repairs a cell (section 4.11): it is removed like a
// small cell (4.10).
#pragma once

#include "Base/Execution.h"
#include "Cells/SmallCellSpec.h"
#include "Shaping/CellComplex.h"
#include "Shaping/RemovedCell.h"

#include <map>

namespace cartesian
{

// Below this part of its box a cell, or a part of one, is removed though it is valid, where one of its faces fails.
constexpr double LargestRefused = 0.1;

// Of these cells, in order: the failing ones (CellFaults.h). For an inverted inner face, the cell from which it is
// seen inverted is removed; for others the smaller of the two, if it is below LargestRefused and keepsWall. Only
// cells with a boundary face go, smaller than `largest` volumes of their box, or than R where their boundary has its
// own; of neighbours only one, the smallest, as that may be enough. Appends what was removed.
void removeRefused(CellComplex& cells, const std::vector<CellKey>& keys, const SmallCellSpec& small,
  double largest, Execution& execution, std::vector<RemovedCell>& removed);

// Whether a cell may be removed: no cell that the slab must not change would fail without it.
bool sparesOthers(const CellComplex& cells, CellKey key);

// Whether a cell may be removed without taking wall from more than one boundary, and the exposed area is about that
// of the removed wall.
bool keepsWall(const CellComplex& cells, CellKey key);

// Cells of one kind side by side, each in one group, in the order of their first.
std::vector<std::vector<CellKey>> sideBySide(
  const CellComplex& cells, std::map<CellKey, std::int32_t> kindOf);

// One cell, noted where it counts (CellComplex::counts).
void remove(CellComplex& cells, CellKey key, std::vector<RemovedCell>& removed);

}
