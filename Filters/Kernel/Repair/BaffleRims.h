// SPDX-License-Identifier: BSD-3-Clause
// Joins the rims of sheets to the walls around them, so that both have the same edges there.
#pragma once

#include "Surface/Surface.h"

namespace cartesian
{

// Divides the triangles of `surface` and `sheets`, which have the same vertices, along each other at the rims of the
// sheets. `tolerance`: how far from walls rims may end, in levels. Returns whether all rims end at walls of their regions;
// those that do not stay as they are.
bool joinRims(Surface& surface, Surface& sheets, double tolerance, Execution& execution);

}
