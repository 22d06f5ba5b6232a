// SPDX-License-Identifier: BSD-3-Clause
// What edits changed goes back into the wall mesh it was opened from (WallOpening.h).
#pragma once

#include "Editing/WallOpening.h"

namespace cartesian
{

// Writes what changed. Hexahedra that did become polyhedra; all else keeps its numbers.
void closeWall(const EditableWall& edited, const Boxes& boxes, const Walls& walls, Sides& sides,
  Nodes& nodes, WallMesh& wall, Execution& execution);

}
