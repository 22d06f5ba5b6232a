// SPDX-License-Identifier: BSD-3-Clause
// Wall faces that are too warped for the layers on them.
//
// Solvers find the centre of a prism from those of its faces: where the polygon's own centre lies off the mean of its
// corners by as much as the prism is high, the prism's centre is outside of it, whatever the ways of its nodes; and where
// layers end on a polygon, so is that of the last cell if the polygon is as warped as all layers are high. Such polygons
// are divided by diagonals, into triangles if need be: these carry prisms of any height.
#pragma once

#include "Boxes/Boxes.h"
#include "Cells/WallMesh.h"
#include "Faces/Nodes.h"
#include "Surface/WallLayerSpec.h"
#include "Surface/Walls.h"

namespace cartesian
{

// Divides faces of the wall where layers are requested, before the mesh is numbered.
void divideWarpedWalls(const Boxes& boxes, const Nodes& nodes, const Walls& walls,
  const WallLayerSpec& layers, WallMesh& mesh);

}
