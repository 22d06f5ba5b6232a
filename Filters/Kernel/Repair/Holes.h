// SPDX-License-Identifier: BSD-3-Clause
// Closes the holes of a surface. Holes at least as wide as a box are reported as leaks.
//
// The rim of a hole is a loop of edges that an odd number of triangles use; such edges always form
// loops. A hole is filled with the triangulation of its rim that has the least area: this restores
// a missing triangle, zips up a slit, and fills a hole in a plane within that plane. A rim of more
// than 128 edges is shortened first: the vertex whose neighbours are closest to each other is cut
// off by a triangle, again and again.
//
// The width of a hole is its hydraulic diameter, four times the area of the filling divided by the
// length of the rim: the diameter of a circle, the side of a square, twice the width of a long
// slit.
#pragma once

#include "Lattice/Meshlines.h"
#include "Repair/RimLoops.h"

namespace cartesian
{

struct Hole
{
  std::vector<std::uint32_t> rim; // vertices, from the lowest on
  double width;                   // in levels
  bool leak;                      // at least as wide as the narrowest side of the global box there
  std::size_t firstTriangle;      // of the triangles that close it
  std::size_t triangles;          // their number
};

// Finds the holes and appends the triangles that close them, oriented like most triangles along the
// rim. They get the boundary of most of those; triangles that close a leak get NoBoundary.
std::vector<Hole> closeHoles(
  Surface& surface, const SurfaceEdges& edges, const Meshlines& planes, Execution& execution);

// Appends the triangles with the least area that close a rim, oriented as above. Returns their area, levels squared.
double fillRim(const Surface& surface, const std::vector<RimEdge>& loop,
  std::vector<std::array<std::uint32_t, 3>>& triangles);

// Only those narrower than `width`, in levels, and not those around sheets, which have nearly their area. `isOfSheet`: of the
// first vertices.
std::vector<Hole> closeNarrowHoles(Surface& surface, double width,
  const std::vector<std::uint8_t>& isOfSheet, const Meshlines& planes, Execution& execution);

}
