// SPDX-License-Identifier: BSD-3-Clause
// No two nodes at one place.
#pragma once

#include "Editing/EditMesh.h"
#include "Editing/WallObjective.h"

namespace cartesian
{

// Walls that touch may have edits put two nodes at one place. All but one of them then move by as few steps of the lattice as
// it takes, to a place that is free, where nothing holds them, and all around is measured again.
void separateNodes(EditMesh& whole, const ObjectiveSpec& spec, Execution& execution);

}
