// SPDX-License-Identifier: BSD-3-Clause
// Box Generation (section 4.5; steps 7 and 8).
//
// Method: the fewest boxes that cover what is inside, by dynamic programming over all ways to split a block by planes (the paper
// names the aim and leaves the search open), then 2:1 balance in passes. Boxes may be long: they are halved along each axis by itself,
// unless RefinementSpec::isotropic.
// Limits: fewest within blocks of 2^3 units along an axis, tiers of blocks beyond; only covers that repeated splitting makes; 32 bits
// for the number of boxes.
#pragma once

#include "Boxes/GlobalStatuses.h"
#include "Boxes/Refinement.h"

namespace cartesian
{

// Statuses come from the surface's crossings along x: every edge of the surface has an even number
// of triangles (SurfaceRepair.h). Global boxes that are intersected are divided, to the depth
// allowed there, into the fewest boxes that cover what is inside or intersected: tier by tier, if
// they are halved more than three times (BlockDivision.h). The forced depth divides these and inside
// boxes further. Then boxes are balanced (Balance.h).
//
// Boxes come in order of their global boxes, in these of their blocks (Blocks.h), and in a block by z, y, x.
//
// Returns the balanced boxes of the layers `kept`. Cells will be made for those of `core`, which
// depend on the others (Parts/Decomposition.h). Throws Error: BadParameter (a box is too thin to be divided),
// TooManyBoxes (for 32 bits).
Boxes generateBoxes(const Surface& surface, const Meshlines& planes, const Shoeboxes& shoeboxes,
  const Refinement& refinement, const GlobalStatuses& statuses, SlabRange core, SlabRange kept,
  Execution& execution);

}
