// SPDX-License-Identifier: BSD-3-Clause
// The gaps that a way passes.
//
// Method (the project's own): the way runs through the middle of gaps, and its distances from walls are small there: a gap
// is where one is a minimum, less than two thirds of what is before and behind. Around each a finer search (LeakWay.h), in which
// walls alone count, finds its middle.
#pragma once

#include "Mesher/LeakPath.h"
#include "Mesher/WallSearch.h"

namespace cartesian
{

// Of a way by these points, which are `spacing` apart; all in levels. Polls.
std::vector<LeakGap> gapsAlong(const std::vector<Vector>& points, double spacing,
  const LeakSearch& search, const WallSearch& walls, Execution& execution);

}
