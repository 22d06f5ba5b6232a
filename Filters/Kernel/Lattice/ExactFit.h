// SPDX-License-Identifier: BSD-3-Clause
// Exact Fit (section 4.7): the pieces of surface triangles between cutting planes.
//
// A fragment is what planes leave of one triangle: a convex polygon whose every side lies on an
// edge of the triangle or on a plane. New corners are computed from the triangle itself, never
// from other corners, so that the same corner comes out the same from every box that needs it.
#pragma once

#include "Lattice/Crossing.h"

namespace cartesian
{

struct Fragment
{
  // Three corners and one more for each of six planes.
  static constexpr int MostCorners = 9;

  // What the side from corner i to corner i + 1 lies on: triangle edge 0, 1, 2 or a plane
  // perpendicular to axis side - FirstPlane, whose level both its corners carry.
  static constexpr std::uint8_t FirstPlane = 3;

  int size = 0;
  std::array<Point, MostCorners> corner;
  std::array<std::uint8_t, MostCorners> side;

  static Fragment whole(const Corners& triangle);
};

// Splits a fragment of `triangle` at a plane. Either part may be empty (size 0); pass null for
// the part that is not needed.
void split(const Corners& triangle, const Fragment& fragment, int axis, Level plane,
  Fragment* below, Fragment* above);

// The part of `triangle` inside the box from `low` to `high` (even levels).
Fragment clip(const Corners& triangle, const Point& low, const Point& high);

}
