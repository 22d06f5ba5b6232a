// SPDX-License-Identifier: BSD-3-Clause
// What the nodes of a wall are: on the surface, on a sharp edge, or a corner; by the faces around them.
#pragma once

#include "Editing/EditMesh.h"

namespace cartesian
{

// Of all nodes at walls and between regions, once faces are measured: EditNode's kind, along, home and leash. Edges at
// which two boundaries meet, or by which the wall turns by more than `featureAngle` (degrees), are sharp.
void findNodeKinds(EditStore& store, double featureAngle, Execution& execution);

}
