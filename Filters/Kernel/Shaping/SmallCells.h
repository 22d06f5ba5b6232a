// SPDX-License-Identifier: BSD-3-Clause
// Small cells (section 4.10) that become a part of a neighbour.
#pragma once

#include "Base/Execution.h"
#include "Shaping/CellComplex.h"

#include <unordered_map>

namespace cartesian
{

// What was tried before on the same cells: not again while nothing near has changed.
struct MergesTried
{
  std::unordered_map<CellKey, std::uint32_t> inVain; // when (CellComplex::mark)
};

// Merges cells smaller than `ratio` of their box, and with `mend` cells at fault, into the neighbour
// with which least is at fault (CellFaults.h): never more than before, of a cell at fault less. Faces
// of the result are joined (FaceJoining.h) where their normals' cosine is at least `leastCosine`. In
// rounds, the smallest first, so that the result depends on the cells only. No two faces get the same
// nodes. Returns how many were merged.
std::size_t mergeSmallCells(CellComplex& cells, double ratio, bool mend, double leastCosine,
  MergesTried& tried, Execution& execution);

}
