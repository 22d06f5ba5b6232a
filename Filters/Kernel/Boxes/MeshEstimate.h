// SPDX-License-Identifier: BSD-3-Clause
// A rough estimate of the number of boxes and of the memory for a mesh, before it is built.
#pragma once

#include "Boxes/Boxes.h"
#include "Boxes/Refinement.h"

namespace cartesian
{

struct MeshEstimate
{
  double inside = 0;      // boxes inside
  double intersected = 0; // boxes that the surface intersects
  double triangles = 0;

  double boxes() const { return inside + intersected; }
  double bytes() const;
};

// Of a mesh without refinement.
MeshEstimate estimateMesh(const Surface& surface, const Meshlines& planes);

// Of one global box that is inside or intersected.
MeshEstimate estimateBox(BoxStatus status, const Depths& depths);

// Throws Error (TooManyBoxes) if the estimate exceeds `mostBytes`.
void checkMemory(const MeshEstimate& estimate, double mostBytes);
void checkMemory(double boxes, double bytes, double mostBytes);

}
