// SPDX-License-Identifier: BSD-3-Clause
// The order that OpenFOAM demands of the faces of patches of type cyclic.
#pragma once

#include "OpenFoam/PolyMeshFiles.h"

namespace cartesian
{

struct CyclicFaces
{
  // Faces of a pair lie at the same place if their middles are no further apart, as a part of their shortest edge.
  static constexpr double Same = 1e-3;
};

// The i-th face of the second patch of each pair becomes that of the i-th of the first, with the first corner at the same place.
// Throws Error (BadMesh): they do not have the same faces, or one has no faces in this mesh.
void orderCyclicFaces(FoamMesh& mesh);

}
