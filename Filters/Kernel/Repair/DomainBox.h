// SPDX-License-Identifier: BSD-3-Clause
// The box of the domain as triangles, a little beyond the first and the last planes, for surfaces that end there: terrain, a
// duct through it. Rims at, near or beyond its sides are continued to it, or cut off by it (ReachedSpaces.h).
#pragma once

#include "Lattice/Meshlines.h"
#include "Surface/FlowDomain.h"
#include "Surface/Surface.h"

namespace cartesian
{

constexpr std::size_t NoAxis = 3;

// Bounds of the grid with room for the sides.
Bounds withRoom(Bounds grid);

// How far around the grid a way may lead that leaks out (LeakPath.h), in levels; and bounds of the grid with room for that.
Level roomAround(const Meshlines& planes);
Bounds withRoomAround(Bounds grid);

// A part of the surface that divides the box: its rims reach the four sides around an axis.
struct Terrain
{
  std::uint32_t triangle;               // its first one
  std::size_t axis;                     // across it
  bool facesUp;                         // that axis, by most of its area
  std::vector<std::uint32_t> triangles; // all of them
};

// `near`: rims at most so many levels inside the box reach its side. In order of their first triangles.
std::vector<Terrain> findTerrain(
  const Surface& surface, const Meshlines& planes, double near, Execution& execution);

// Continues rims of some triangles that are so near to sides inside the box to these, with their boundaries; not to the sides
// across one axis, unless it is NoAxis.
void continueToSides(Surface& surface, const Meshlines& planes, double near,
  const std::vector<std::uint32_t>& triangles, std::size_t butAcross, Execution& execution);

// Adds the sides, with normals that point out of the box and NoBoundary. Returns the first triangle: two for each side, in the
// order of DomainSide.
std::size_t addSides(Surface& surface, const Meshlines& planes);

}
