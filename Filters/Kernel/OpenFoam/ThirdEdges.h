// SPDX-License-Identifier: BSD-3-Clause
// Points with two edges, which OpenFOAM's solvers take away when they undo refinement, anywhere in the mesh (removeFaces of v1912). Where
// a face would be left with less than three corners, they stop.
//
// Method: such a face keeps a corner to which another face with it is divided, so that it has three edges. A division must leave both
// parts a normal like that of the whole, or is not made.
#pragma once

#include "OpenFoam/PolyMeshFiles.h"

namespace cartesian
{

// The mesh, which has no zones and no addressing, with some faces divided in two; cells and points stay.
FoamMesh withThirdEdges(FoamMesh mesh);

}
