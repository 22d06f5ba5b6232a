// SPDX-License-Identifier: BSD-3-Clause
// The cells of the wall made good for solvers (sections 3, 4.10, 4.11).
#pragma once

#include "Editing/EditMesh.h"

namespace cartesian
{

void improveWall(EditMesh& mesh);

}
