// SPDX-License-Identifier: BSD-3-Clause
#include "Repair/NearbyTriangles.h"

#include <algorithm>

namespace cartesian
{

namespace
{

// Of cells along the longest side of all triangles together.
constexpr double MostCells = 64;

}

NearbyTriangles::NearbyTriangles(
  const Surface& surface, const std::vector<std::uint32_t>& triangles, double reach)
  : surface_(surface)
  , reach_(reach)
  , size_(2 * reach)
{
  Vector low{ 1e300, 1e300, 1e300 };
  Vector high{ -1e300, -1e300, -1e300 };
  for (const std::uint32_t t : triangles)
  {
    for (const Point& p : surface.corners(t))
    {
      for (std::size_t axis = 0; axis < 3; ++axis)
      {
        low[axis] = std::min(low[axis], double(p[axis]));
        high[axis] = std::max(high[axis], double(p[axis]));
      }
    }
  }
  for (std::size_t axis = 0; axis < 3; ++axis)
  {
    size_ = std::max(size_, (high[axis] - low[axis]) / MostCells);
  }
  const Vector aside{ reach, reach, reach };
  for (const std::uint32_t t : triangles)
  {
    const Corners c = surface.corners(t);
    Vector from = toVector(c[0]);
    Vector to = from;
    for (const Point& p : c)
    {
      for (std::size_t axis = 0; axis < 3; ++axis)
      {
        from[axis] = std::min(from[axis], double(p[axis]));
        to[axis] = std::max(to[axis], double(p[axis]));
      }
    }
    const Cell first = cellOf(minus(from, aside));
    const Cell last = cellOf(plus(to, aside));
    for (std::int64_t i = first[0]; i <= last[0]; ++i)
    {
      for (std::int64_t j = first[1]; j <= last[1]; ++j)
      {
        for (std::int64_t k = first[2]; k <= last[2]; ++k)
        {
          cells_[keyOf({ i, j, k })].push_back(t);
        }
      }
    }
  }
}

NearbyTriangles::Cell NearbyTriangles::cellOf(const Vector& place) const
{
  Cell cell;
  for (std::size_t axis = 0; axis < 3; ++axis)
  {
    cell[axis] = static_cast<std::int64_t>(std::floor(place[axis] / size_));
  }
  return cell;
}

// Cells far from each other may share a key: then there are more triangles to compare.
std::int64_t NearbyTriangles::keyOf(const Cell& cell)
{
  constexpr std::int64_t Most = 1 << 20;
  return ((cell[0] & (Most - 1)) * Most + (cell[1] & (Most - 1))) * Most + (cell[2] & (Most - 1));
}

}
