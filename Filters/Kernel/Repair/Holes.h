// SPDX-License-Identifier: BSD-3-Clause
// Holes of the surface, closed: those wider than a box are leaks.
//
// A hole's rim is a loop of edges with an odd number of triangles; such edges always form loops. It is
// filled by the triangles between its vertices that have the least area in all: a missing triangle
// comes back as it was, a slit is zipped up, a hole in a plane is filled in the plane. A rim of more
// than 128 edges is first shortened, by the triangle with the shortest new edge, again and again.
//
// The width of a hole is four times the area of its filling by the length of its rim: a circle's
// diameter, a square's side, twice the width of a long slit.
#pragma once

#include "Lattice/Meshlines.h"
#include "Surface/SurfaceEdges.h"

namespace cartesian
{

struct Hole
{
  std::vector<std::uint32_t> rim; // vertices, from the lowest on
  double width;                   // in levels
  bool leak;                      // as wide as the narrowest side of a global box there
  std::size_t firstTriangle;      // of those that close it
  std::size_t triangles;
};

// Finds the holes and appends the triangles that close them, turned as most around them. Their boundary is
// that of most triangles along the rim; of a leak, NoBoundary.
std::vector<Hole> closeHoles(
  Surface& surface, const SurfaceEdges& edges, const Meshlines& planes, Execution& execution);

}
