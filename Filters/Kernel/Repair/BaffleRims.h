// SPDX-License-Identifier: BSD-3-Clause
// Joins the rims of sheets to the walls around them, so that both have the same edges there.
#pragma once

#include "Surface/Surface.h"

namespace cartesian
{

struct RimSpec
{
  double tolerance; // how far from walls rims may end, in levels
  double sagitta;   // how far walls may bend away from an edge of a rim, as a part of its length
};

struct JoinedRims
{
  bool any = false; // whether any corner of a rim is on a wall
  bool all = true;  // whether all rims end at walls
};

// Divides the triangles of `surface` and `sheets`, which have the same vertices, along each other at the rims of the
// sheets, where they end at walls of their regions; other rims stay as they are.
JoinedRims joinRims(Surface& surface, Surface& sheets, const RimSpec& spec, Execution& execution);

}
