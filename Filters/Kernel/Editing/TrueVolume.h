// SPDX-License-Identifier: BSD-3-Clause
// Facets cut off what a curved surface encloses, and edits what they move: each wall knows that deficit. Nodes of smooth
// walls move along their normals until it is paid, except where a face would become poor.
#pragma once

#include "Editing/EditMesh.h"
#include "Editing/WallObjective.h"

namespace cartesian
{

// Costs are valid before and afterwards; deficits are what is left of them.
void redistributeVolume(EditMesh& mesh, const ObjectiveSpec& spec, Execution& execution);

}
