// SPDX-License-Identifier: BSD-3-Clause
// Boxes to be divided because walls face each other.
#pragma once

#include "Boxes/Octants.h"
#include "Boxes/SizingSpec.h"
#include "Surface/Surface.h"

namespace cartesian
{

// Appends octants from wall to wall, so small that spec.cellsAcrossGaps of them fit between, or of the largest
// depth. Walls face each other where a line from one along its normal, through what is meshed, meets the other
// at less than 60 degrees from its normal; a side of a box around bodies is a wall too.
void addGaps(const SizingSpec& spec, const Surface& surface, const Meshlines& planes,
  Octants& octants, Execution& execution);

}
