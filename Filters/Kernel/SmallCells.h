// Small cells (section 4.10) that become a part of a neighbour.
#pragma once

#include "CellComplex.h"
#include "Execution.h"

namespace cartesian
{

// Merges cells smaller than `ratio` of their box, and cells at fault, into the neighbour that they
// share most area with, of those with which nothing becomes worse (of a cell at fault: something
// better). Faces of the result are joined (FaceJoining.h). In rounds, the smallest first, so that the
// result depends on the cells only. Returns how many were merged.
std::size_t mergeSmallCells(
  CellComplex& cells, double ratio, bool mend, double leastCosine, Execution& execution);

}
