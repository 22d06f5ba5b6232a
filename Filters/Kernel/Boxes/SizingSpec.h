// SPDX-License-Identifier: BSD-3-Clause
// Depths that the surface itself asks for, by its shape.
#pragma once

#include "Base/Range.h"

namespace cartesian
{

struct SizingSpec
{
  static constexpr Range CurvatureAngles{ 0, 180 };
  static constexpr Range GapCells{ 0, 64 };

  // Degrees: boxes are divided until the surface turns by no more in each, but for sharp edges; 0: never.
  double curvatureAngle = 0;
  int featureDepth = 0;     // of boxes that a sharp edge passes through, 0 to DeepestLevel
  int cellsAcrossGaps = 0;  // boxes from wall to wall where two face each other; 0: any number
  int largestDepth = 3;     // where angle and gaps end, 0 to DeepestLevel
  double featureAngle = 30; // degrees: edges at which the surface turns by more are sharp

  bool any() const { return curvatureAngle > 0 || featureDepth > 0 || cellsAcrossGaps > 0; }
};

}
