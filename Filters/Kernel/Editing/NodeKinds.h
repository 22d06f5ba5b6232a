// SPDX-License-Identifier: BSD-3-Clause
// What the nodes of a wall are: on the surface, on a sharp edge, or a corner; as the surface's features say, and by the faces
// around them where those are mute.
#pragma once

#include "Base/RawVector.h"
#include "Editing/EditMesh.h"
#include "Surface/PointKind.h"

namespace cartesian
{

// Of all nodes at walls and between regions, once faces are measured: EditNode's kind, along, home and leash. Edges at
// which two boundaries meet, or by which the wall turns by more than `featureAngle` (degrees), are sharp. `known`: of
// nodes, as Nodes::kinds.
void findNodeKinds(
  EditStore& store, const RawVector<PointKind>& known, double featureAngle, Execution& execution);

}
