// SPDX-License-Identifier: BSD-3-Clause
// Facets cut off what a curved surface encloses, and edits what they move: each wall knows that debt. Nodes of smooth
// walls move along their normals until it is paid, except where a face would become poor.
#pragma once

#include "Acceptance/WallObjective.h"
#include "Editing/EditMesh.h"

namespace cartesian
{

// Costs are valid before and afterwards; debts are what is left of them.
void payDebts(EditStore& store, const ObjectiveSpec& spec, Execution& execution);

}
