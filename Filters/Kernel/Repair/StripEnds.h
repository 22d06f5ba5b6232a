// SPDX-License-Identifier: BSD-3-Clause
// Closes holes that strips between rims leave at their ends: where several strips meet, where a rim reaches beyond the other.
//
// Where such holes touch at a vertex, each is the one with the smallest angle there: it is as narrow as strips are.
#pragma once

#include "Repair/RimStrips.h"

namespace cartesian
{

// Adds the triangles that close holes at most `widest` levels wide (Holes.h), each hole to the first strip that it touches, which is
// at least as wide then.
void closeEnds(
  const Surface& surface, double widest, std::vector<RimStrip>& strips, Execution& execution);

}
