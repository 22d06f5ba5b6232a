// SPDX-License-Identifier: BSD-3-Clause
// Triangles that occur in the surface more than once (step 4): the same three vertices, in either
// direction.
#pragma once

#include "Surface/SurfaceEdges.h"

namespace cartesian
{

// Groups of triangles with the same vertices, ascending within each group.
struct Duplicates
{
  std::vector<std::size_t> start; // of each group, and the end
  std::vector<std::uint32_t> triangles;

  std::size_t groups() const { return start.size() - 1; }
};

struct DroppedTriangle
{
  std::uint32_t triangle;
  std::array<std::uint32_t, 3> vertices;
};

Duplicates findDuplicates(const Surface& surface, const SurfaceEdges& edges, Execution& execution);

// Drops duplicates by collapsing them into their first vertex. Connected groups are treated alike:
// - One triangle of each group stays if most of their edges need it to be closed (a triangle
//   written twice), or if no edge needs it (a body written twice).
// - None stays if most edges are closed without it (a wall between two bodies that touch, a plate
//   without thickness). But if all edges were oriented consistently, those stay that no opposite
//   triangle cancels (a wall where two bodies overlap).
// The triangle of the lowest boundary stays. Returns the dropped triangles, group by group.
std::vector<DroppedTriangle> dropDuplicates(
  Surface& surface, const SurfaceEdges& edges, const Duplicates& duplicates);

}
