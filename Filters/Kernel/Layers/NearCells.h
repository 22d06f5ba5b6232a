// SPDX-License-Identifier: BSD-3-Clause
// The cells near walls that get layers: the only ones that layers change.
#pragma once

#include "Layers/LayeredWall.h"
#include "Quality/FaceList.h"

namespace cartesian
{

struct NearCells
{
  CellFaces cells;
  std::vector<Id> places; // of each cell in the mesh, as CellArrays has them
  std::vector<std::uint32_t>
    wallNode; // of each of the mesh's points: if it is a node on the wall, that
  std::vector<std::uint32_t>
    origin; // ... the one that is fewest cells away (the lowest of them); None: farther
  std::vector<std::uint8_t>
    mayMove; // ... 1: all cells at the point are near, and it is not on the wall
};

std::vector<double> volumesOf(
  const CellFaces& cells, const std::vector<double>& points, Execution& execution);

// Those that `rings` cells or fewer separate from the wall, and one more ring, whose outer points do not move.
NearCells findNearCells(
  const OutputMesh& mesh, const LayeredWall& wall, int rings, Execution& execution);

}
