// SPDX-License-Identifier: BSD-3-Clause
// Cells connected by faces. Elements are boxes, for hexahedra, then the cells of the wall mesh.
#pragma once

#include "Base/ConcurrentSets.h"
#include "Cells/WallMesh.h"

namespace cartesian
{

// Those of hexahedra that touch each other are united.
ConcurrentSets unitedHexahedra(
  const Boxes& boxes, const Sides& sides, const WallMesh& wall, Execution& execution);

// How many parts each region falls into, in the order of the regions given; 0: it has no cells. Removed cells are not
// there, and nothing passes through a baffle. The boxes must be those of the whole grid.
std::vector<std::size_t> countParts(const Boxes& boxes, const Walls& walls, const Sides& sides,
  const WallMesh& wall, Execution& execution);

}
