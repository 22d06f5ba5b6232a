// SPDX-License-Identifier: BSD-3-Clause
// Neighbouring boxes of not too different levels (section 4.5, figure 2).
//
// No side of a box may be touched by more than one split line of its neighbours in each direction:
// across a side, levels along it differ by one at most. A box that is too coarse is halved in that
// direction. This goes pass by pass, from the deepest level down: the pass of level n halves boxes
// until none coarser than n touches one finer than n. What is finer than n it leaves as it is, so
// what becomes of a box depends on nothing but the boxes that touched it before the pass: on no
// order of visits, and in all passes together on boxes at most balanceReach() global boxes away.
#pragma once

#include "Boxes/Boxes.h"

namespace cartesian
{

// How many global boxes away a box of `depth` makes others finer.
constexpr std::uint32_t balanceReach(int depth)
{
  return depth > 1 ? static_cast<std::uint32_t>(depth) - 1 : 0;
}

// The lowest axis along which a box must be halved in the pass of this level, or NoAxis. `boxes`: as
// they were before the pass; `box` may be a part of one of them.
constexpr std::uint8_t NoAxis = 3;
std::uint8_t axisToHalve(const Boxes& boxes, const PackedBox& box, int level);

}
