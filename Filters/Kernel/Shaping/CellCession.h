// SPDX-License-Identifier: BSD-3-Clause
// Between two regions no cell can be removed, as that would leave a hole: a cell that cannot be repaired goes to the
// other region (as to the outside at a boundary, section 4.10). Only thin cells do: the interface, its edges and
// corners move by a small part of a box at most.
#pragma once

#include "Shaping/CellMerging.h"

namespace cartesian
{

// Below this part of its box a cell between two regions is a wall without thickness.
constexpr double FlatCell = 1e-6;

// Whether a cell joined one of the region beyond its faces. Only if the result passes, its neighbours pass as before,
// and it has no face at the boundary.
bool cede(CellComplex& cells, CellKey key, CellMerger& merger);

// Of these, in order: those smaller than `largest` volumes of their box. Whether any did.
bool cedeCells(CellComplex& cells, const std::vector<CellKey>& keys, double largest,
  CellMerger& merger, Execution& execution);

}
