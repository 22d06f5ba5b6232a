// SPDX-License-Identifier: BSD-3-Clause
// An estimate of the number of boxes and of the memory for a mesh, before it is built: from the surface alone,
// then from what global boxes hold, then from the boxes, then from the patches. Of the boxes it is 1 to 2 times
// what is taken (Testing/Benchmark: Benchmark memory).
#pragma once

#include "Boxes/Boxes.h"
#include "Boxes/Refinement.h"
#include "Boxes/Shoeboxes.h"

namespace cartesian
{

struct MemoryLimit
{
  double bytes; // for a mesh, or each part of it

  // What decides how much it takes.
  bool exact = false; // all patches are exact
  bool shapes = true; // cells are shaped
};

struct MeshEstimate
{
  double inside = 0;      // boxes inside
  double intersected = 0; // boxes that the surface intersects
  double pieces = 0;      // of triangles in one box each
  double triangles = 0;   // of the surface

  double boxes() const { return inside + intersected; }
  double bytes(const MemoryLimit& limit) const;

  // Where the corners of all patches are counted.
  double bytes(const MemoryLimit& limit, double corners) const;

  // All but the triangles, which all parts of a mesh have in common.
  void add(const MeshEstimate& part);
};

// Of a mesh without refinement.
MeshEstimate estimateMesh(const Surface& surface, const Meshlines& planes);

// Of one global box that is inside or intersected, and of the triangles that pass through it.
MeshEstimate estimateBox(BoxStatus status, const Depths& depths, const TriangleRange& triangles);

// Of boxes that are made.
MeshEstimate estimateMesh(const Surface& surface, const Shoeboxes& shoeboxes, const Boxes& boxes);

// Throws Error (TooManyBoxes) if the estimate exceeds the limit.
void checkMemory(const MeshEstimate& estimate, const MemoryLimit& limit);
void checkMemory(double boxes, double bytes, const MemoryLimit& limit);

}
