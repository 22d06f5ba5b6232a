// SPDX-License-Identifier: BSD-3-Clause
// Removes tips and slivers of almost no volume that no neighbour can absorb: the faces that close them replace their
// patches, like the paper's IP patches (section 4.11).
#pragma once

#include "Cells/SmallCellSpec.h"
#include "Shaping/CellComplex.h"

namespace cartesian
{

// Removes, in order, those of these cells that are smaller than `largest` volumes of their box (or than R where their
// boundary has its own), if that leaves no step: exposed faces point in the direction of a patch of the cell, and,
// joined with their neighbours as far as `joins` allows, are no worse for solvers than before. Adjacent tips are
// removed together, or else one of them.
void removeTips(CellComplex& cells, const std::vector<CellKey>& keys, const SmallCellSpec& small,
  double largest, const JoinSpec& joins);

}
