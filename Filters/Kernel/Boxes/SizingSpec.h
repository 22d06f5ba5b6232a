// SPDX-License-Identifier: BSD-3-Clause
// Refinement required by the shape of the surface, or by a field.
#pragma once

#include "Base/Range.h"
#include "Surface/WallLayerSpec.h"

#include <algorithm>
#include <array>
#include <vector>

namespace cartesian
{

// A box in which no box may be larger than a size; in user units.
struct WantedSize
{
  std::array<double, 3> low;
  std::array<double, 3> high; // no lower; flat ones are points, lines or rectangles
  double size;                // more than 0
};

struct SizingSpec
{
  static constexpr Range CurvatureAngles{ 0, 180 };
  static constexpr Range GapCells{ 0, 64 };

  // Degrees: boxes are divided until the surface turns by no more than this in each, except at sharp edges; 0: never.
  double curvatureAngle = 0;
  int featureDepth = 0;       // of boxes that a sharp edge passes through, 0 to DeepestLevel
  double cellsAcrossGaps = 0; // boxes from wall to wall where two face each other; 0: any number
  std::vector<WantedSize> sizes;
  std::vector<double> sizeOfTriangle; // of each of the view, user units, 0: any; empty: all any
  int largestDepth = 3;               // where angle, gaps and sizes end, 0 to DeepestLevel
  double featureAngle = 30;           // degrees: edges at which the surface turns by more are sharp

  // Flat prisms (isFlat) end where a wall turns by more than `angleAtLayers` degrees in a box. Boxes at walls that get some
  // are halved up to so often more than all else but sizes requires, until the wall turns less.
  int halvingsAtLayers = 0;
  double angleAtLayers = 30;
  WallLayerSpec layers; // their number and first thickness are known

  bool any() const { return asksEverywhere() || halvingsAtLayers > 0; }
  bool asksEverywhere() const
  {
    return curvatureAngle > 0 || featureDepth > 0 || cellsAcrossGaps > 0 || asksForSizes();
  }
  bool asksForSizes() const { return !sizes.empty() || !sizeOfTriangle.empty(); }

  // The most times that a box may be halved for all this, apart from layers.
  int deepest() const
  {
    const bool byDepth = curvatureAngle > 0 || cellsAcrossGaps > 0 || asksForSizes();
    return std::max(featureDepth, byDepth ? largestDepth : 0);
  }
};

}
