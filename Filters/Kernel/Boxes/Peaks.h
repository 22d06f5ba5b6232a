// SPDX-License-Identifier: BSD-3-Clause
// Places where the surface is tangent to planes across an axis: peaks, ridges, pits and saddles of its height.
//
// Points of patches keep a distance from planes (PlaneClearance.h). Where the surface crosses a plane that shifts the
// crossing. Where it is tangent to a plane nearer than that, its points stand on a ledge along the plane instead: the
// cell between them is a sliver as thick as the distance, or its neighbour's neck is.
#pragma once

#include "Base/Execution.h"
#include "Surface/Surface.h"

#include <cstdint>
#include <map>
#include <vector>

namespace cartesian
{

// Twice the area along an axis of walls at one level, in square levels.
struct WallAreas
{
  double domainBelow = 0;
  double domainAbove = 0;
  double around = 0; // of peaks, with the domain around them: no plane cuts them off

  double all() const { return domainBelow + domainAbove + around; }
};

using WallsByLevel = std::map<Level, WallAreas>;

// Twice the area along the axis: positive where the normal points up.
double projectedArea(const Corners& c, std::size_t axis);

// Of the vertices for which `isNear` is 1: the levels where the walls of a region neither rise through nor fall through
// a vertex, and the area of the triangles around it that are not steep. On a ridge at one level that is one vertex or
// more. Also where bodies of one region touch: a plane along the line of contact is not to cut both there. Vertices of
// flat walls and of sheets are left out, but not edges of rims of sheets along a level. The surface is oriented.
WallsByLevel peaksAmong(const Surface& surface, std::size_t axis,
  const std::vector<std::uint8_t>& isNear, Execution& execution);

}
