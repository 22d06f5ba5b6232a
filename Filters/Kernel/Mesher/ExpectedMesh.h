// SPDX-License-Identifier: BSD-3-Clause
// Estimates the size of a mesh, for several box sizes, before meshing.
#pragma once

#include "Base/Execution.h"
#include "Mesher/Options.h"
#include "Surface/Surface.h"

#include <vector>

namespace cartesian
{

struct ExpectedMesh
{
  double size = 0;  // of boxes, user units
  double boxes = 0; // at least 1
  double cells = 0; // with layers
  double bytes = 0; // that are taken at the peak
};

// With their number and first thickness, beside boxes of the largest depth that boundaries ask for. `surface`: its bounds, in
// user units.
struct ExpectedLayers
{
  WallLayerSpec spec;
  double box; // beside them
};
ExpectedLayers expectedLayers(const Options& options, const Bounds& surface);

// For the grid with all refinement and layers in the options. If only areas of the surface matter, they suffice; else
// the boxes are made, unless there are far too many. Throws Error: EmptySurface,
// BadCoordinate, BadParameter, FlawedSurface (of a region).
ExpectedMesh expectedMesh(const SurfaceView& surface, const Options& options, Execution& execution);

struct ExpectedRow
{
  ExpectedMesh mesh;
  bool isAsked = false; // it is of the options' cell size, not of another
};

// The same with other sizes beside: the longest side by 25, 50, 100 and 200. From the largest to the smallest, each
// once.
std::vector<ExpectedRow> expectedRows(
  const SurfaceView& surface, const Options& options, Execution& execution);

}
