// SPDX-License-Identifier: BSD-3-Clause
// The wall, from raw cells to ones that solvers take: simplified, short edges snapped, then the loop, first in general, then
// for what still fails, and last the volume made true.
#pragma once

#include "Editing/EditMesh.h"

namespace cartesian
{

// Faces and cells are measured (EditMeasures.h).
void improveWall(EditMesh& mesh, Execution& execution);

}
