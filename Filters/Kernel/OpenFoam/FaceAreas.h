// SPDX-License-Identifier: BSD-3-Clause
// Areas of a mesh's faces.
#pragma once

#include "Lattice/Vector.h"
#include "OpenFoam/PolyMeshFiles.h"

namespace cartesian
{

// Twice the area, along the normal, outwards of the owner.
Vector doubleAreaOf(const FoamMesh& mesh, std::size_t face);

// Of `count` faces from `first` on, in units of the mesh.
double areaOfFaces(const FoamMesh& mesh, std::size_t first, std::size_t count);

}
