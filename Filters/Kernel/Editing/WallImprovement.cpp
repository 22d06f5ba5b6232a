// SPDX-License-Identifier: BSD-3-Clause
#include "Editing/WallImprovement.h"

namespace cartesian
{

void improveWall(EditMesh&) {}

}
