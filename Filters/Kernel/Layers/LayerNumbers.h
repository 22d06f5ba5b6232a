// SPDX-License-Identifier: BSD-3-Clause
// The numbers of cells in a mesh with layers: those of a stack follow the cell below it, so that coupled cells are
// close in a solver's matrix, and the cells of a part of the grid have consecutive numbers.
#pragma once

#include "Layers/PrismStacks.h"

namespace cartesian
{

// Of the mesh's cells in order of their numbers, then of the stacks' as they are there.
std::vector<Id> numbersWithLayers(const OutputMesh& mesh, const PrismStacks& stacks);

// Gives faces the new numbers, and puts them in the order of these.
void renumber(LayeredBoundary& boundary, const std::vector<Id>& numbers);

}
