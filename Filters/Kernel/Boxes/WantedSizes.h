// SPDX-License-Identifier: BSD-3-Clause
// Boxes to be divided because a field requires smaller ones.
#pragma once

#include "Boxes/Octants.h"
#include "Boxes/Shoeboxes.h"
#include "Boxes/SizingSpec.h"

namespace cartesian
{

// Appends octants that overlap a prescribed size (SizingSpec::sizes, sizeOfTriangle): none of their edges is longer
// than the least of these sizes, or they have the largest depth.
void addWantedSizes(const SizingSpec& spec, const Surface& surface, const Shoeboxes& shoeboxes,
  const Meshlines& planes, Octants& octants, Execution& execution);

}
