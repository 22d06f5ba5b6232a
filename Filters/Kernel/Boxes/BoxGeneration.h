// SPDX-License-Identifier: BSD-3-Clause
// Box Generation (section 4.5; steps 7 and 8).
#pragma once

#include "Boxes/GlobalStatuses.h"
#include "Boxes/Refinement.h"

namespace cartesian
{

// Every edge of the surface has an even number of triangles (SurfaceRepair.h): statuses come from the
// crossings along x. Global boxes that are intersected are divided to the
// depth allowed there into the fewest boxes that cover what is inside or intersected; forced depth
// divides them and inside boxes further. Then boxes are balanced (Balance.h).

// The boxes of the layers `kept`, balanced. Cells will be made for those of `core`; the others are what
// they depend on (Parts/Decomposition.h).
//
// Throws Error (TooManyBoxes) where the mesh would take more bytes than `mostBytes`.
Boxes generateBoxes(const Surface& surface, const Meshlines& planes, const Shoeboxes& shoeboxes,
  const Refinement& refinement, const GlobalStatuses& statuses, Layers core, Layers kept,
  double mostBytes, Execution& execution);

// How large a mesh will be, roughly, before anything is built.
struct MeshEstimate
{
  double inside = 0; // boxes
  double intersected = 0;
  double triangles = 0;

  double boxes() const { return inside + intersected; }
  double bytes() const;
};

// Without refinement.
MeshEstimate estimateMesh(const Surface& surface, const Meshlines& planes);

// Of one global box.
MeshEstimate estimateBox(BoxStatus status, const Depths& depths);

// Throws TooManyBoxes where the estimate exceeds `mostBytes`.
void checkMemory(const MeshEstimate& estimate, double mostBytes);

}
