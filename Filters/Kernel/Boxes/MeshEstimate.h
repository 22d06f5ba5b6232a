// SPDX-License-Identifier: BSD-3-Clause
// An estimate of the number of boxes and of the memory for a mesh, before it is built: from the surface alone,
// then from what global boxes hold, then from the boxes, then from the patches. It is the peak of those stages
// that can take the most, and 1 to 2 times what is taken (Testing/Benchmark: Benchmark memory).
#pragma once

#include "Boxes/Boxes.h"
#include "Boxes/Refinement.h"
#include "Boxes/Shoeboxes.h"

namespace cartesian
{

struct MemoryLimit
{
  double bytes; // for a mesh, or each part of it

  // What determines the memory.
  bool exact = false; // all patches are exact
  bool edits = true;  // cells are edited
  int layers = 0;     // of prisms at walls
  int threads = 1;
};

struct PatchCorners
{
  double all = 0;
  double kept = 0; // except most of those of simplified detail
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
  double bytes(const MemoryLimit& limit, const PatchCorners& corners) const;

  // Except for the triangles, which all parts of a mesh share.
  void add(const MeshEstimate& part);
};

// Of so many boxes, and of triangles of the surface.
MeshEstimate estimateOf(double boxes, double intersected, double triangles);

// Of a mesh without refinement.
MeshEstimate estimateMesh(const Surface& surface, const Meshlines& planes);

// For each triangle: how many global boxes a plane of its area would pass through, divided among those that it
// passes through. Their sum in a box, times 4^d, is about the number of boxes of depth d in it that it intersects.
std::vector<float> areasInBoxes(
  const Surface& surface, const Meshlines& planes, const Shoeboxes& shoeboxes);

// Of one global box that is inside or intersected, and of the triangles that pass through it. `areas`: of all
// triangles (above); may be empty if the box is not divided. `touched`: where depths.touched says that there are parts.
// `transitionLayers`: around what the surface requires (RefinementSpec), at least 1.
MeshEstimate estimateBox(BoxStatus status, const Depths& depths,
  const std::vector<TouchedPart>& touched, int transitionLayers, const TriangleRange& triangles,
  const std::vector<float>& areas);

// Of boxes that are made, for each layer of the grid.
std::vector<MeshEstimate> estimateLayers(
  const Shoeboxes& shoeboxes, const Boxes& boxes, Execution& execution);

// Throws Error (TooManyBoxes) if the estimate exceeds the limit.
void checkMemory(const MeshEstimate& estimate, const MemoryLimit& limit);
void checkMemory(double boxes, double bytes, const MemoryLimit& limit);

}
