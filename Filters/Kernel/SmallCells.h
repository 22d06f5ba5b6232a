// Small cells (section 4.10) that become a part of a neighbour.
#pragma once

#include "CellComplex.h"
#include "Execution.h"

namespace cartesian
{

// Merges cells smaller than `ratio` of their box into the neighbour that they share most area with,
// of those with which they fulfil the angle conditions. In rounds, the smallest first, so that the
// result depends on the cells only. Faces of what they become a part of are joined where they lie on
// one plane, or in one boundary with normals this close (cosine). Returns how many were merged.
std::size_t mergeSmallCells(
  CellComplex& cells, double ratio, double leastCosine, Demand demand, Execution& execution);

}
