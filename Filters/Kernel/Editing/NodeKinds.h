// SPDX-License-Identifier: BSD-3-Clause
// What the nodes of a wall are: on the surface, on a sharp edge, or a corner; as the surface's features say, and by the faces
// around them where those are mute.
#pragma once

#include "Base/RawVector.h"
#include "Editing/EditMesh.h"
#include "Surface/PointKind.h"

namespace cartesian
{

// What the features of the surface say of nodes, as Nodes::kinds.
struct KnownKinds
{
  const RawVector<PointKind>& ofNodes;
  bool
    knowsEdges; // edges between nodes that are on none are smooth, whatever their angle (Patches)

  PointKind of(std::uint32_t number) const
  {
    return number < ofNodes.size() ? ofNodes[number] : PointKind::OffSurface;
  }
};

// Of all nodes at walls and between regions, once faces are measured: EditNode's kind, along, home and maxDisplacement. Edges at
// which two boundaries meet, or by which the wall turns by more than `featureAngle` (degrees), are sharp.
void findNodeKinds(
  EditMesh& whole, const KnownKinds& known, double featureAngle, Execution& execution);

}
