// SPDX-License-Identifier: BSD-3-Clause
// User options for short edges (EdgeCollapse.h).
#pragma once

#include "Base/Range.h"

namespace cartesian
{

struct CollapseSpec
{
  static constexpr Range Ratios{ 0, 0.3 };

  // Edges shorter than this part of their box's shortest edge collapse, longer ones where a smooth surface bends
  // (EdgeCollapse.cpp); 0: none. Small wall faces obstruct layers, so with layers it is at least this, or 0 (measured
  // on CAD and scans: from 0.1 to 0.3 a third of the faults between layers is left).
  static constexpr double WithLayers = 0.3;

  double ratio = 0.1;
};

}
