// SPDX-License-Identifier: BSD-3-Clause
// The triangulated surface on the lattice (sections 4.1, 4.2; steps 2 and 3).
#pragma once

#include "Base/Execution.h"
#include "Lattice/Crossing.h"
#include "Surface/Winding.h"

#include <vector>

namespace cartesian
{

// Triangles in user units, as the caller has them; borrowed. Either way round.
struct SurfaceView
{
  const double* points = nullptr; // x, y, z of each point
  std::size_t pointCount = 0;
  const std::uint32_t* triangles = nullptr; // three points each
  std::size_t triangleCount = 0;
  const std::int32_t* boundary = nullptr; // boundary index of each triangle, or null: all 0
  const long long* cells = nullptr;       // the user's number of each, for messages, or null
};

// The bounds of all points that triangles use. Throws Error: EmptySurface, BadCoordinate (with
// the point's id), BadParameter (a triangle that names no point).
Bounds boundsOf(const SurfaceView& view);

// Boundary index where there was no surface: a leak, the end of the grid.
constexpr std::int32_t NoBoundary = -1;

struct Surface
{
  Lattice lattice;
  std::vector<Point> vertices;                         // distinct
  std::vector<std::array<std::uint32_t, 3>> triangles; // either way round, until oriented
  std::vector<std::int32_t> boundary;                  // one a triangle
  std::vector<std::uint8_t>
    byParity; // 1: no consistent orientation (Winding.h); empty: all have one

  Corners corners(std::size_t triangle) const
  {
    const auto& t = triangles[triangle];
    return { vertices[t[0]], vertices[t[1]], vertices[t[2]] };
  }

  // What crossing a triangle changes; `up`: its normal points along the way.
  Winding crossing(std::size_t triangle, bool up) const
  {
    return !byParity.empty() && byParity[triangle] != 0 ? Winding{ 0, true }
                                                        : Winding{ up ? -1 : 1, false };
  }
};

// Puts a surface on the lattice. Points that share all three levels become one vertex.
Surface onLattice(const SurfaceView& view, const Lattice& lattice, Execution& execution);

// Area in square, volume in cubic user units.
double areaOf(const Surface& surface);
double volumeOf(const Surface& surface);

}
