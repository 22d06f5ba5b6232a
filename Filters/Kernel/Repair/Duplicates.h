// SPDX-License-Identifier: BSD-3-Clause
// Triangles that are in the surface more than once (step 4): the same three vertices, either way
// round.
#pragma once

#include "Surface/SurfaceEdges.h"

namespace cartesian
{

// Triangles of the same vertices, ascending, one group after the other.
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

Duplicates findDuplicates(const Surface& surface, const SurfaceEdges& edges);

// Makes triangles of each group collapse into their first vertex, so that at most one is left.
// Groups that hang together are treated alike. One triangle of each stays where most of their edges
// need it to be closed (a triangle written twice), or none cares (a body written twice). None stays
// where most edges are closed without (a wall between two bodies that touch, a plate without
// thickness); but where all edges were given consistently, as many stay as no other one cancels (a
// wall of two bodies that overlap). Of several boundaries, the lowest stays.
// Returns what was dropped, in order of groups.
std::vector<DroppedTriangle> dropDuplicates(
  Surface& surface, const SurfaceEdges& edges, const Duplicates& duplicates);

}
