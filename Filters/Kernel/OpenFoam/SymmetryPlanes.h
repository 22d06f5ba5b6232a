// SPDX-License-Identifier: BSD-3-Clause
// Which symmetries are planes.
#pragma once

#include "OpenFoam/PolyMeshFiles.h"

namespace cartesian
{

// The patches of a mesh, with a type for those that have none and are symmetries by name (isSymmetry): symmetryPlane if
// their faces lie in one plane as exactly as OpenFOAM demands, else symmetry. So is a patch of a piece, as others may
// have the rest of it.
std::vector<FoamPatch> withSymmetries(const FoamMesh& mesh);

}
