// SPDX-License-Identifier: BSD-3-Clause
// One mesh as a mesh for each region, as OpenFOAM's solvers for several regions need it.
#pragma once

#include "OpenFoam/PolyMeshFiles.h"

namespace cartesian
{

// The regions of the cells of a mesh.
struct FoamRegions
{
  std::vector<std::string> names;    // different OpenFOAM words
  std::vector<std::uint32_t> ofCell; // index of names
};

// The mesh of one region. Cells, faces and points keep their order. Faces between it and another one are the
// patch <region>_to_<other>, after the others, in the order that the other's patch has too; they sample each
// other.
FoamMesh meshOfRegion(const FoamMesh& whole, const FoamRegions& regions, std::uint32_t region);

}
