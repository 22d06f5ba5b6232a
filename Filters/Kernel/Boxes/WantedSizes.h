// SPDX-License-Identifier: BSD-3-Clause
// Where boxes must be divided because a field asks for smaller ones.
#pragma once

#include "Boxes/Octants.h"
#include "Boxes/Shoeboxes.h"
#include "Boxes/SizingSpec.h"

namespace cartesian
{

// Appends octants that overlap what asks for a size (SizingSpec::sizes, sizeOfTriangle): no edge of theirs is longer
// than the least of these sizes, or they have the largest depth.
void addWantedSizes(const SizingSpec& spec, const Surface& surface, const Shoeboxes& shoeboxes,
  const Meshlines& planes, Octants& octants, Execution& execution);

}
