// SPDX-License-Identifier: BSD-3-Clause
// A quick estimate of a mesh's size, from its surface alone.
#pragma once

#include "Surface/Surface.h"

namespace cartesian
{

// In user units.
struct SurfaceSize
{
  double volume;                 // enclosed, if the triangles are oriented consistently
  std::array<double, 3> shadows; // areas of all triangles projected along x, y and z
  double longest;                // side of the bounding box
};

// Throws Error: EmptySurface, BadCoordinate, BadParameter (see boundsOf).
SurfaceSize sizeOf(const SurfaceView& view);

// The expected number of boxes of this size (along x, y, z; user units) if those at the surface are
// halved `depth` times: the mean over all positions of the grid, for a surface whose radii of
// curvature and thickness are larger than a box. There are fewer if flat walls lie on meshlines.
double expectedBoxes(const SurfaceSize& surface, const std::array<double, 3>& box, int depth);

}
