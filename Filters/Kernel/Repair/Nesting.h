// SPDX-License-Identifier: BSD-3-Clause
// How deep closed sheets lie in each other: 0 for a body in nothing, 1 for a cavity in it, 2 for a body in that.
//
// A sheet lies in a larger one if most of its samples do (RayParityVotes.h), unless the two pass through each other: then
// they are bodies that are united, if both were given with their normals on the same side; otherwise the
// smaller one is a cavity that reaches through the wall, if most of it is inside, or three quarters where it is not
// known how they were given. But what passes through a wall and meets things behind it belongs to these.
#pragma once

#include "Repair/ComponentIntersections.h"
#include "Repair/RayParityVotes.h"

namespace cartesian
{

struct SheetShapes
{
  std::vector<double> volume; // of each sheet: six times, with all triangles facing as its first
  std::vector<int> givenWay;  // of each sheet: 1 with its normals outward, -1 inward, 0 if neither
};

// Of each sheet; those that are not closed have none.
std::vector<int> depthsOf(
  const SheetShapes& shapes, const RayParityVotes& votes, const ComponentIntersections& crossings);

}
