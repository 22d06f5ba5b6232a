// The last resort where neither a cut, nor a merge, nor an IP patch mends a cell (section 4.11): it is
// removed as a small cell is (4.10).
#pragma once

#include "CellComplex.h"
#include "Execution.h"

namespace cartesian
{

// Removes cells with refused faces (CellFitness.h); of the two cells of an inner face the smaller. Only
// cells with a boundary face that are smaller than `largest` volumes of their box, or than R where
// their boundary has its own. In rounds, the smallest first, so that the result depends on the cells
// only. Returns how many were removed.
std::size_t removeRefusedCells(
  CellComplex& cells, const CellSpec& spec, double largest, Execution& execution);

}
