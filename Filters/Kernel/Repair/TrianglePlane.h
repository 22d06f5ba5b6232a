// SPDX-License-Identifier: BSD-3-Clause
// On which side of a triangle's plane points of the lattice are, exactly.
#pragma once

#include "Lattice/Plane.h"
#include "Lattice/Vector.h"
#include "Surface/Surface.h"

#include <algorithm>
#include <limits>

namespace cartesian
{

// The plane of a triangle, in double precision and, where that does not suffice, exactly.
class TrianglePlane
{
public:
  explicit TrianglePlane(const Corners& t)
    : corners_(t)
  {
    const Vector u = minus(t[1], t[0]);
    const Vector v = minus(t[2], t[0]);
    for (std::size_t axis = 0; axis < 3; ++axis)
    {
      const std::size_t b = (axis + 1) % 3;
      const std::size_t c = (axis + 2) % 3;
      normal_[axis] = u[b] * v[c] - u[c] * v[b];
      size_[axis] = std::abs(u[b] * v[c]) + std::abs(u[c] * v[b]);
    }
  }

  // 1 if a point lies on the side that the normal points to, -1 on the other, 0 on the plane.
  int sideOf(const Point& p) const
  {
    // The differences are exact; six more operations round.
    constexpr double rounding = 8 * std::numeric_limits<double>::epsilon();
    const Vector d = minus(p, corners_[0]);
    const double height = dot(normal_, d);
    const double size =
      size_[0] * std::abs(d[0]) + size_[1] * std::abs(d[1]) + size_[2] * std::abs(d[2]);
    if (std::abs(height) > rounding * size)
    {
      return height > 0 ? 1 : -1;
    }
    return sign(exactHeight(p));
  }

  // In levels, rounded.
  double distanceTo(const Point& p) const
  {
    return std::abs(dot(normal_, minus(p, corners_[0]))) / norm(normal_);
  }

  // A point's height above the plane, times twice the triangle's area.
  Wide exactHeight(const Point& p) const
  {
    const std::array<Wide, 3> normal = exactNormal(corners_);
    Wide height = 0;
    for (std::size_t axis = 0; axis < 3; ++axis)
    {
      height += normal[axis] * (static_cast<Wide>(p[axis]) - corners_[0][axis]);
    }
    return height;
  }

private:
  const Corners& corners_;
  Vector normal_;
  Vector size_; // sum of the magnitudes of the normal's terms
};

// Along which a triangle's projection is the largest, the first of equal ones.
inline std::size_t axisOfNormal(const Corners& triangle)
{
  std::array<Wide, 3> size = exactNormal(triangle);
  for (Wide& s : size)
  {
    s = s < 0 ? -s : s;
  }
  return static_cast<std::size_t>(std::max_element(size.begin(), size.end()) - size.begin());
}

// Along which a triangle's projection is about the largest, the same for all that are nearly parallel; -1: it has no
// area.
inline int axisAcross(const Corners& triangle)
{
  constexpr double nearly = 0.75;
  const std::array<Wide, 3> normal = exactNormal(triangle);
  std::array<double, 3> size{};
  for (std::size_t axis = 0; axis < 3; ++axis)
  {
    size[axis] = std::abs(static_cast<double>(normal[axis]));
  }
  const double most = std::max({ size[0], size[1], size[2] });
  for (int axis = 0; axis < 3; ++axis)
  {
    if (most > 0 && size[static_cast<std::size_t>(axis)] >= nearly * most)
    {
      return axis;
    }
  }
  return -1;
}

// 1 if d is on the side of the triangle abc from which it is seen counter-clockwise, -1 on the other, 0 in its plane.
inline int orientation(const Point& a, const Point& b, const Point& c, const Point& d)
{
  const Corners t = { a, b, c };
  return TrianglePlane(t).sideOf(d);
}

}
