// SPDX-License-Identifier: BSD-3-Clause
// The shortest way between two places on a grid of points, where lengths count more next to walls.
//
// Method: Dijkstra 1959 (Numerische Mathematik 1, page 269). That lengths are weighted by the distance from
// walls is the project's own: a widest path, which maximizes the least distance alone, may be any way where it is wide.
#pragma once

#include "Mesher/PointGrid.h"
#include "Mesher/WallSearch.h"

#include <optional>

namespace cartesian
{

struct WayEnds
{
  std::optional<Vector> from; // levels; none: the ends of the grid
  Vector to;
};

// Places from one end to the other; none: they are not connected. `weight`: of walls, so many levels. Of equally long ways
// the one by points with lower numbers. Polls.
std::vector<Vector> findWay(const PointGrid& grid, const WallSearch& walls, const WayEnds& ends,
  double weight, Execution& execution);

}
