// SPDX-License-Identifier: BSD-3-Clause
// Joins the rims of sheets to the walls around them, so that both have the same edges there.
#pragma once

#include "Lattice/Vector.h"
#include "Surface/Surface.h"

namespace cartesian
{

// Divides the triangles of `surface` and `sheets`, which have the same vertices, along each other at the rims of the
// sheets. `tolerance`: how far from walls rims may end, in levels. Returns an edge of a rim that does not end at a wall
// of its region, or nothing.
struct LooseEdge
{
  bool any = false;
  std::uint32_t triangle = 0; // of `sheets`
  Vector middle{};            // levels
};
LooseEdge joinRims(Surface& surface, Surface& sheets, double tolerance, Execution& execution);

}
