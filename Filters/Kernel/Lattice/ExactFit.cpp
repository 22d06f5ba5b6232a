// SPDX-License-Identifier: BSD-3-Clause
#include "Lattice/ExactFit.h"

#include "Base/Rings.h"

#include <algorithm>

namespace cartesian
{

namespace
{

void append(Fragment* part, const Point& corner, std::uint8_t side)
{
  if (part)
  {
    part->corner[part->size] = corner;
    part->side[part->size] = side;
    ++part->size;
  }
}

// Where the fragment's side that starts at corner p meets the plane.
Point crossSide(const Corners& triangle, std::uint8_t side, const Point& p, int axis, Level plane)
{
  if (side < Fragment::FirstPlane)
  {
    return crossPlane(triangle[side], following(triangle, side), axis, plane);
  }
  const int other = side - Fragment::FirstPlane;
  Point at = p;
  at[axis] = plane;
  return crossLine(triangle, 3 - axis - other, at);
}

}

Fragment Fragment::whole(const Corners& triangle)
{
  Fragment f;
  f.size = 3;
  for (std::uint8_t i = 0; i < 3; ++i)
  {
    f.corner[i] = triangle[i];
    f.side[i] = i;
  }
  return f;
}

void split(const Corners& triangle, const Fragment& fragment, int axis, Level plane,
  Fragment* below, Fragment* above)
{
  if (below)
  {
    below->size = 0;
  }
  if (above)
  {
    above->size = 0;
  }
  const auto planeSide = static_cast<std::uint8_t>(Fragment::FirstPlane + axis);
  for (int i = 0; i < fragment.size; ++i)
  {
    const Point& p = fragment.corner[i];
    const Point& q = fragment.corner[i + 1 < fragment.size ? i + 1 : 0];
    const bool pBelow = p[axis] < plane;
    const bool qBelow = q[axis] < plane;
    append(pBelow ? below : above, p, fragment.side[i]);
    if (pBelow != qBelow)
    {
      const Point x = crossSide(triangle, fragment.side[i], p, axis, plane);
      append(pBelow ? below : above, x, planeSide);
      append(pBelow ? above : below, x, fragment.side[i]);
    }
  }
}

Fragment clip(const Corners& triangle, const Point& low, const Point& high)
{
  std::array<Fragment, 2> fragments{ Fragment::whole(triangle), {} };
  Fragment* now = fragments.data();
  Fragment* next = now + 1;
  for (int axis = 0; axis < 3; ++axis)
  {
    Level least = ~Level(0);
    Level most = 0;
    for (int i = 0; i < now->size; ++i)
    {
      least = std::min(least, now->corner[i][axis]);
      most = std::max(most, now->corner[i][axis]);
    }
    if (least < low[axis])
    {
      split(triangle, *now, axis, low[axis], nullptr, next);
      std::swap(now, next);
    }
    if (most > high[axis])
    {
      split(triangle, *now, axis, high[axis], next, nullptr);
      std::swap(now, next);
    }
  }
  return *now;
}

}
