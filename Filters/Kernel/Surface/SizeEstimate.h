// SPDX-License-Identifier: BSD-3-Clause
// A quick estimate of a mesh's size, from its surface alone.
#pragma once

#include "Surface/Surface.h"

#include <map>

namespace cartesian
{

using Shadows = std::array<double, 3>; // areas of triangles projected along x, y and z

// In user units.
struct SurfaceSize
{
  double volume; // enclosed, if the triangles are oriented consistently
  Shadows shadows;
  double longest; // side of the bounding box
};

// Throws Error: EmptySurface, BadCoordinate, BadParameter (see boundsOf).
SurfaceSize sizeOf(const SurfaceView& view);

// Of the triangles of each boundary.
std::map<std::int32_t, Shadows> shadowsOfBoundaries(const SurfaceView& view);

// How many boxes of this size (along x, y, z; user units), halved `depth` times, a surface passes through, as a mean
// over all positions of the grid.
double expectedIntersected(const Shadows& shadows, const std::array<double, 3>& box, int depth);

// The same with the larger boxes between those and boxes that are not halved.
double expectedBoxesAlong(const Shadows& shadows, const std::array<double, 3>& box, int depth);

// Boxes inside that it does not pass through.
double expectedInside(const SurfaceSize& surface, const std::array<double, 3>& box);

// All of them, for a surface whose radii of curvature and thickness are larger than a box. There are fewer if flat walls
// lie on meshlines.
double expectedBoxes(const SurfaceSize& surface, const std::array<double, 3>& box, int depth);

}
