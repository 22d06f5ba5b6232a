// SPDX-License-Identifier: BSD-3-Clause
// User options for short edges (ShortEdges.h).
#pragma once

#include "Base/Range.h"

namespace cartesian
{

struct ShortEdgeSpec
{
  static constexpr Range Ratios{ 0, 0.3 };

  // Edges along the wall shorter than three times this part of their box's collapse, if that does not make cells much
  // worse; 0: none for its length alone.
  double ratio = 0.1;
};

}
