// SPDX-License-Identifier: BSD-3-Clause
// Which patches are in which zones of a mesh.
#pragma once

#include "OpenFoam/PolyMeshFiles.h"

namespace cartesian
{

// Of each zone of a whole mesh; of a piece none, as the patches go on in others.
std::vector<ZoneOfMesh> facesOfZones(const FoamMesh& mesh);

}
