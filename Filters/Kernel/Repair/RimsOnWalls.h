// SPDX-License-Identifier: BSD-3-Clause
// Open rims that end on other parts of the surface, or a hair before or behind them, get the same edges as these: a nozzle on a vessel,
// a fin on a plate (BaffleRims.h, part by part).
#pragma once

#include "Surface/Surface.h"

namespace cartesian
{

// `tolerance`: how far from walls rims may end, in levels. All triangles have numbers in the view.
void joinRimsToWalls(Surface& surface, double tolerance, Execution& execution);

}
