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
  double ratio = 0.1;
};

}
