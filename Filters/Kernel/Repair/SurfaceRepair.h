// SPDX-License-Identifier: BSD-3-Clause
// What is done to any surface before it is meshed (steps 4 and 6): duplicates and loose triangles dropped,
// triangles oriented, holes closed.
#pragma once

#include "Repair/Duplicates.h"
#include "Repair/Holes.h"
#include "Repair/SurfaceCheck.h"

namespace cartesian
{

struct SurfaceRepair
{
  std::vector<DroppedTriangle>
    duplicates;       // triangles that were there before, or a wall between bodies
  SurfaceCheck check; // without duplicates, oriented, with its holes
  std::vector<DroppedTriangle>
    loose;                 // triangles that share no edge with another: they enclose nothing
  std::vector<Hole> holes; // in order of their lowest vertices

  std::size_t leaks() const;
};

// Afterwards every line enters each component as often as it leaves it, or crosses it an even number of
// times (Surface::byParity). Triangles keep their numbers: what is dropped collapses into a point, those that
// close holes follow at the end. A surface without flaws whose normals point out of the domain stays as it is.
SurfaceRepair repair(Surface& surface, const Meshlines& planes, Execution& execution);

}
