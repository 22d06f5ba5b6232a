// SPDX-License-Identifier: BSD-3-Clause
// How far points of patches keep away from cutting planes that they are not on.
//
// Dual Levels only keep them one level away. Where the surface passes a corner or an edge of a box, that
// leaves edges as short as one level; solvers want none shorter than a millionth of the box.
// Neighbours of other sizes must move a common point alike: the clearance is that of the smallest boxes.
#pragma once

#include "Lattice/Meshlines.h"
#include "Surface/Surface.h"

#include <algorithm>

namespace cartesian
{

class PlaneClearance
{
public:
  // 2^-13 of the smallest boxes, but at most 2^-10 of the surface's extent, so that no body is lost.
  PlaneClearance(const Surface& surface, const Meshlines& planes)
    : planes_(planes)
  {
    Point low = surface.vertices.front();
    Point high = low;
    for (const Point& p : surface.vertices)
    {
      for (std::size_t axis = 0; axis < 3; ++axis)
      {
        low[axis] = std::min(low[axis], p[axis]);
        high[axis] = std::max(high[axis], p[axis]);
      }
    }
    for (std::size_t axis = 0; axis < 3; ++axis)
    {
      most_[axis] = (high[axis] - low[axis]) >> 10;
    }
  }

  // An odd number of levels, along an axis in the global boxes of this index.
  Level of(std::size_t axis, std::uint32_t index) const
  {
    const Level width = planes_[axis][index + 1] - planes_[axis][index];
    return std::min(width >> (BitsOfBox + planes_.planeLevel), most_[axis]) | 1;
  }

private:
  static constexpr int BitsOfBox = 13;

  const Meshlines& planes_;
  std::array<Level, 3> most_{};
};

}
