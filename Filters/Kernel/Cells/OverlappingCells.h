// SPDX-License-Identifier: BSD-3-Clause
// Cells on the same side of one and the same wall: they overlap. Where a surface passes through itself, two of its walls
// can come to have the same nodes.
#pragma once

#include "Cells/WallMesh.h"

namespace cartesian
{

// Cells of the wall mesh to remove so that none overlap, in order: where two faces have the same nodes, the smaller
// one of two cells on the same side. `nodes`: how many there are. Cells that are removed do not count.
std::vector<std::uint32_t> overlappingCells(
  const Boxes& boxes, std::size_t nodes, const WallMesh& wall, Execution& execution);

}
