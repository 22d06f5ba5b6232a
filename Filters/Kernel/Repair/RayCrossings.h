// SPDX-License-Identifier: BSD-3-Clause
// Where an axis-parallel line crosses the triangles of a surface.
#pragma once

#include "Base/Sorting.h"
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

// With one of several lines.
struct NumberedCrossing : RayCrossing
{
  std::uint32_t line;
};

// Of the line along an axis through a place, whose other two levels are even; in order. `tree`: of the surface.
std::vector<RayCrossing> crossingsOf(
  const Surface& surface, const TriangleTree& tree, std::size_t along, const Point& place);

// The same by line for several places, at least one: on all threads. If there are too many crossings to be in memory at
// once, all places but the first 1024 are dropped.
Buckets<NumberedCrossing> crossingsOf(const Surface& surface, const TriangleTree& tree,
  std::size_t along, std::vector<Point>& places, Execution& execution);

}
