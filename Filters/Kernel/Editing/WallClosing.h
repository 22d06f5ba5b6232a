// SPDX-License-Identifier: BSD-3-Clause
// What was opened (WallOpening.h) becomes the wall mesh again, and the nodes that edits made are among all nodes.
#pragma once

#include "Editing/WallOpening.h"

namespace cartesian
{

// `wall` has its cells alone (WallMesh::forgetFaces). Hexahedra that changed become polyhedra; nodes keep their numbers.
void closeWall(const EditableWall& edited, const Boxes& boxes, const Walls& walls, Sides& sides,
  Nodes& nodes, WallMesh& wall, Execution& execution);

}
