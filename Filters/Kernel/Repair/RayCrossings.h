// SPDX-License-Identifier: BSD-3-Clause
// Where an axis-parallel line crosses the triangles of a surface.
#pragma once

#include "Repair/TriangleTree.h"

namespace cartesian
{

struct RayCrossing
{
  Level level; // along the line
  std::uint32_t triangle;
  bool up; // the triangle's normal points along the line

  bool operator<(const RayCrossing& other) const
  {
    return level != other.level ? level < other.level : triangle < other.triangle;
  }
};

// Of the line along an axis through a place, whose other two levels are even; in order. `tree`: of the surface.
std::vector<RayCrossing> crossingsOf(
  const Surface& surface, const TriangleTree& tree, std::size_t along, const Point& place);

}
