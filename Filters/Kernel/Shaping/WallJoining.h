// SPDX-License-Identifier: BSD-3-Clause
// Joins boundary faces of one cell that leave no room for layers side by side, and small ones with larger ones, as thin
// prisms between thick ones are poor cells for solvers.
#pragma once

#include "Shaping/CellUnion.h"
#include "Surface/WallLayerSpec.h"

#include "Base/Execution.h"

namespace cartesian
{

// Of these cells, in order: if the face between prisms on two of their faces would fail, or one of these is small,
// and the cell passes with the joined face as before.
void joinWalls(CellComplex& cells, const std::vector<CellKey>& keys, const WallLayerSpec& layers,
  Execution& execution);

}
