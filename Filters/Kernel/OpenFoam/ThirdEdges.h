// SPDX-License-Identifier: BSD-3-Clause
// Points with two edges, which OpenFOAM's solvers take away when they undo refinement, anywhere in the mesh (removeFaces of v1912): walls
// change there, and where a face would be left with less than three corners, the solver stops.
//
// Method: a face with such a point is divided between it and the corner that leaves both parts upright as their cells see them.
// Where none is, the point stays as it is.
#pragma once

#include "OpenFoam/PolyMeshFiles.h"

namespace cartesian
{

// The mesh, which has no zones and no addressing, with some faces divided in two; cells and points stay.
FoamMesh withThirdEdges(FoamMesh mesh);

}
