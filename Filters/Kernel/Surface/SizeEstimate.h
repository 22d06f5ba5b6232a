// SPDX-License-Identifier: BSD-3-Clause
// How large a mesh will be, from its surface alone and in no time: before anything is meshed.
#pragma once

#include "Surface/Surface.h"

namespace cartesian
{

// In user units.
struct SurfaceSize
{
  double volume;                 // inside, if the triangles face one way
  std::array<double, 3> shadows; // areas of all triangles, projected along x, y and z
  double longest;                // side of the bounding box
};

// Throws Error: EmptySurface, BadCoordinate, BadParameter (see boundsOf).
SurfaceSize sizeOf(const SurfaceView& view);

// About how many boxes of this size (along x, y, z; user units) there will be, those at the surface
// halved `depth` times: the mean over all positions of the grid, for a surface whose curvature radii
// and thickness are larger than a box. Where flat walls lie on meshlines there are fewer.
double expectedBoxes(const SurfaceSize& surface, const std::array<double, 3>& box, int depth);

}
