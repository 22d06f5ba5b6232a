// SPDX-License-Identifier: BSD-3-Clause
// What the user chooses about short edges (EdgeCollapse.h).
#pragma once

#include "Base/Range.h"

namespace cartesian
{

struct CollapseSpec
{
  static constexpr Range Ratios{ 0, 0.3 };

  // Edges shorter than this part of their box's shortest edge collapse, longer ones where a smooth surface
  // bends (EdgeCollapse.cpp); 0: none.
  // Layers stand badly on small faces at the wall, so with them it is no less than this, or 0 (measured on CAD and
  // scans: from 0.1 to 0.3 a third of the faults between layers is left).
  static constexpr double WithLayers = 0.3;

  double ratio = 0.1;
};

}
