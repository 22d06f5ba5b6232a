// SPDX-License-Identifier: BSD-3-Clause
// Which cells may be edited: those at walls, and one ring around them.
#pragma once

#include "Cells/Boundary.h"

namespace cartesian
{

// Cells of intersected boxes, others with a wall other than an end of the grid, and those that share a node with one;
// none that was removed. In the order of their boxes, then of their nodes' places.
std::vector<CellKey> cellsToEdit(const MeshParts& parts, Execution& execution);

// The box of a cell or hexahedron.
inline std::uint32_t boxOf(const WallMesh& wall, CellKey key)
{
  return isHexahedron(key) ? boxOfHexahedron(key) : wall.cells[key].box;
}

}
