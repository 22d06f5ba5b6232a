// SPDX-License-Identifier: BSD-3-Clause
// How far the nearest wall is from a place, and whether walls are between two places. Places are in levels.
#pragma once

#include "Lattice/NearestPlace.h"
#include "Repair/TriangleTree.h"

#include <tuple>

namespace cartesian
{

class WallSearch
{
public:
  WallSearch(const Surface& walls, Execution& execution)
    : walls_(walls)
    , tree_(walls, execution)
  {
  }

  const Surface& surface() const { return walls_; }

  Vector nearest(const Vector& place) const
  {
    const auto nearestOf = [&](std::uint32_t t) { return nearestPlace(walls_.corners(t), place); };
    return nearestOf(
      tree_.nearest(place, [&](std::uint32_t t) { return norm(minus(nearestOf(t), place)); }));
  }

  double distanceTo(const Vector& place) const { return norm(minus(nearest(place), place)); }

  // Whether a segment passes through one.
  bool areBetween(const Vector& from, const Vector& to) const
  {
    Vector low;
    Vector high;
    for (std::size_t axis = 0; axis < 3; ++axis)
    {
      std::tie(low[axis], high[axis]) = std::minmax(from[axis], to[axis]);
    }
    bool are = false;
    tree_.forEachWithin(low, high, [&](std::uint32_t t) { are = are || passes(from, to, t); });
    return are;
  }

private:
  bool passes(const Vector& from, const Vector& to, std::uint32_t triangle) const
  {
    std::array<Vector, 3> c;
    for (std::size_t i = 0; i < 3; ++i)
    {
      c[i] = minus(toVector(walls_.corners(triangle)[i]), from);
    }
    const Vector along = minus(to, from);
    const Vector normal = cross(minus(c[1], c[0]), minus(c[2], c[0]));
    const bool isAbove = dot(normal, c[0]) > 0;
    const auto side = [&](std::size_t i) { return dot(along, cross(c[i], c[(i + 1) % 3])) > 0; };
    return isAbove != (dot(normal, minus(c[0], along)) > 0) && side(0) == side(1) &&
      side(1) == side(2);
  }

  const Surface& walls_;
  TriangleTree tree_;
};

}
