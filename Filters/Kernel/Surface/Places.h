// SPDX-License-Identifier: BSD-3-Clause
// Where something is on a surface, for messages and for tests of what contains what.
#pragma once

#include "Base/Error.h"
#include "Lattice/Vector.h"
#include "Surface/Surface.h"

namespace cartesian
{

// The mean of a triangle's corners, in levels.
inline Vector middleOf(const Surface& surface, std::size_t triangle)
{
  Vector sum{ 0, 0, 0 };
  for (const Point& p : surface.corners(triangle))
  {
    sum = plus(sum, { double(p[0]) / 3, double(p[1]) / 3, double(p[2]) / 3 });
  }
  return sum;
}

// Of a triangle between vertices, in levels squared.
inline double areaOf(const Surface& surface, const std::array<std::uint32_t, 3>& triangle)
{
  const Point& at = surface.vertices[triangle[0]];
  return norm(cross(
           minus(surface.vertices[triangle[1]], at), minus(surface.vertices[triangle[2]], at))) /
    2;
}

// Of one of its triangles.
inline double areaOf(const Surface& surface, std::size_t triangle)
{
  return areaOf(surface, surface.triangles[triangle]);
}

// A place in levels, as the user knows it: "(x, y, z)".
inline std::string placeOf(const Surface& surface, const Vector& levels)
{
  std::string text = "(";
  for (int axis = 0; axis < 3; ++axis)
  {
    const double origin = surface.lattice.position(axis, 0);
    text += (axis > 0 ? ", " : "") +
      number(origin + levels[static_cast<std::size_t>(axis)] * surface.lattice.step());
  }
  return text + ")";
}

}
