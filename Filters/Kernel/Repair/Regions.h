// SPDX-License-Identifier: BSD-3-Clause
// The walls between several regions, out of their surfaces.
//
// Each region has closed surfaces of its own, which may touch those of others: along the same triangles, or
// along others in the same plane (Imprint.h). A region may lie in another; where several regions are, the
// first of them is. What is left are triangles between two regions, or between one and outside, each once:
// the only surface that all later steps know, so that both regions have the same faces there.
#pragma once

#include "Lattice/Meshlines.h"
#include "Surface/Surface.h"

#include <string>
#include <vector>

namespace cartesian
{

// Fills Surface::walls; boundary indices then are those of walls. `names`: of the regions, for messages.
// Throws Error (FlawedSurface): a region's surface is not closed, or passes through another's, or nothing is
// left of it.
void separateRegions(Surface& surface, const Meshlines& planes,
  const std::vector<std::string>& names, Execution& execution);

}
