// SPDX-License-Identifier: BSD-3-Clause
// The jump from each stack to the mesh: the volume of its last layer by that of the cell beside it. Solvers have died of
// jumps that they passed when there were more layers, whatever the layers themselves were like.
#pragma once

#include "Layers/NearCells.h"
#include "Layers/StackCells.h"

namespace cartesian
{

// Of each face of the wall; 0: it has no stack, or one that tapers. `volumes`: of the near cells, with layers.
std::vector<double> lastByCells(const LayeredWall& wall, const LayerHeights& heights,
  const NearCells& near, const std::vector<double>& volumes, Execution& execution);

}
