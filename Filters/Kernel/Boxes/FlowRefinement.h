// SPDX-License-Identifier: BSD-3-Clause
// Refinement for the flow around bodies, if the user only specifies the number of boxes along them.
#pragma once

#include "Lattice/Meshlines.h"
#include "Surface/FlowDomain.h"

#include <vector>

namespace cartesian
{

// Boxes that are halved in a box of the domain.
struct FlowZone
{
  Bounds box; // user units
  int depth;  // 1 to DeepestLevel
};

struct FlowRefinement
{
  int depth = 0;               // along the bodies, 0 to DeepestLevel
  std::vector<FlowZone> zones; // around the bodies, and from there into the wake

  // User units.
  double length = 0; // the bodies' longest side
  double size = 0;   // the longest edge of boxes along it

  bool hasAlong(int boxes) const { return size * boxes <= length; }
};

// Along the bodies' longest side there are at least DomainSpec::boxesAlong boxes, if DeepestLevel allows for them; around
// them boxes are at most twice as large as along them, in the wake four times, unless 1/60 and 1/30 of that side is
// fine enough (FlowRefinement.cpp). `surface`: the bounds of the bodies, user
// units. Throws Error: BadParameter, BadCellSize, TooManyBoxes (boxAround, fittedTo).
FlowRefinement flowRefinement(
  const DomainSpec& domain, const GridSpec& grid, const Bounds& surface);

}
