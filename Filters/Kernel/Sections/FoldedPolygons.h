// SPDX-License-Identifier: BSD-3-Clause
// Polygons of a division of a plane whose edges cross, or that are clockwise.
#pragma once

#include "Sections/PlanePolygons.h"

namespace cartesian
{

struct FoldedPolygons
{
  static constexpr int Parts = 8; // of a way, that are tried
};

// One by one, in order, a point of such a polygon that is not on the outline moves towards the mean of those that it has edges to, by the
// least part of the way that leaves fewer of them; until there are none, or none that this helps. Returns the points that have
// moved.
std::vector<std::uint32_t> unfold(PlanePolygons& polygons);

}
