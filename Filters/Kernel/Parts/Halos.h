// SPDX-License-Identifier: BSD-3-Clause
// The layers of global boxes around a part (Decomposition.h) on which its cells depend.
#pragma once

#include "Boxes/Boxes.h"

namespace cartesian
{

// The cells of one more layer tell which of a part's points are used, and which of its faces have lost their neighbour.
constexpr std::uint32_t HaloOfCells = 1;

// The layers whose cells must be cut correctly, for those of `core` to be correct in the end. Edits of the wall
// (Editing/WallImprovement.h) follow each other from zone to zone without bound: each part edits all of it.
inline SlabRange layersForCells(SlabRange core, bool editsWall, std::uint32_t allLayers)
{
  return editsWall ? SlabRange{ 0, allLayers } : core.grown(HaloOfCells, allLayers);
}

}
