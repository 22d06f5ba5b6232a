// SPDX-License-Identifier: BSD-3-Clause
// The faces between cells of two regions.
#pragma once

#include "Cells/WallMesh.h"

namespace cartesian
{

// Makes the patches between two regions faces of two cells, below which is the region behind: from then on whatever
// changes such a face changes it for both. Patches keep their numbers; no cell has those any more.
void makeInterfaces(const Walls& walls, WallMesh& wall);

}
