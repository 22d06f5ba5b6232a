// SPDX-License-Identifier: BSD-3-Clause
// Nodes slide along the wall until its faces lie under the centres of their cells: solvers take the gradient at a wall along
// the line between them as if it were across.
#pragma once

#include "Editing/EditMesh.h"
#include "Editing/WallObjective.h"

namespace cartesian
{

void centreWalls(EditMesh& whole, const ObjectiveSpec& spec, Execution& execution);

}
