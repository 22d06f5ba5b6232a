// SPDX-License-Identifier: BSD-3-Clause
// Exact Fit (section 4.7): clips surface triangles between cutting planes.
//
// A fragment is the part of one triangle between planes: a convex polygon whose sides lie on the
// triangle's edges or on planes. New corners are computed from the triangle itself, never from
// other corners, so that every box that needs a corner gets the same one.
#pragma once

#include "Lattice/Crossing.h"

namespace cartesian
{

struct Fragment
{
  // Three, and one for each of six planes.
  static constexpr int MostCorners = 9;

  // side[i] is what the side from corner i to corner i + 1 lies on: edge 0, 1 or 2 of the triangle, or a plane
  // perpendicular to the axis side[i] - FirstPlane, on whose level both corners are.
  static constexpr std::uint8_t FirstPlane = 3;

  int size = 0;
  std::array<Point, MostCorners> corner;
  std::array<std::uint8_t, MostCorners> side;

  static Fragment whole(const Corners& triangle);
};

// Splits a fragment of `triangle` at a plane. Either part may be empty (size 0), or null if it is
// not needed.
void split(const Corners& triangle, const Fragment& fragment, int axis, Level plane,
  Fragment* below, Fragment* above);

// The part of `triangle` inside the box from `low` to `high` (even levels).
Fragment clip(const Corners& triangle, const Point& low, const Point& high);

}
