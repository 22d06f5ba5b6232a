// SPDX-License-Identifier: BSD-3-Clause
// Boundary faces of one cell on which boundary layers could not stand side by side become one, and small ones join
// larger ones, as thin prisms between thick ones are poor cells for solvers.
#pragma once

#include "Shaping/CellUnion.h"
#include "Surface/WallLayerSpec.h"

#include "Base/Execution.h"

namespace cartesian
{

// Of these cells, in order: where solvers would refuse the face between prisms on two of their faces, or one of these
// is small, and where they accept the cell with one face as they did before.
void joinWalls(CellComplex& cells, const std::vector<CellKey>& keys, const WallLayerSpec& layers,
  Execution& execution);

}
