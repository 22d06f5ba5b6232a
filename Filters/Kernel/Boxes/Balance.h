// SPDX-License-Identifier: BSD-3-Clause
// Balances the levels of neighbouring boxes (section 4.5, figure 2): 2:1 in each direction.
//
// At most one split line of its neighbours may touch a side of a box in each direction: across a
// side, the levels along it differ by at most one. A box that is too coarse is halved in that
// direction. This is done in passes, from the deepest level down: pass n halves boxes until none
// coarser than level n touches one finer than n. It does not change boxes finer than n, so its
// effect on a box depends only on the boxes that touched it before the pass, not on the order of
// visits; and the effect of all passes depends only on boxes at most balanceReach() global boxes
// away.
#pragma once

#include "Boxes/Boxes.h"

namespace cartesian
{

// How many global boxes away a box of this depth may cause others to be halved.
constexpr std::uint32_t balanceReach(int depth)
{
  return depth > 1 ? static_cast<std::uint32_t>(depth) - 1 : 0;
}

// The lowest axis along which a box must be halved in the pass of this level, or NoAxis. `boxes`:
// before the pass; `box` may be a part of one of them.
constexpr std::uint8_t NoAxis = 3;
std::uint8_t axisToHalve(const Boxes& boxes, const PackedBox& box, int level);

}
