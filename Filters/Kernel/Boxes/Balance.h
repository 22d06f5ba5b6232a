// SPDX-License-Identifier: BSD-3-Clause
// Balances the levels of neighbouring boxes (section 4.5, figure 2): 2:1 in each direction.
//
// Across a side, levels differ by at most one in each of the three directions: along the side, as in
// the paper, so that at most one split line of the neighbours touches it in each direction; and
// across it, so that no box is much longer than its neighbour where a solver interpolates between
// the two. A box that is too coarse is halved. This is done in passes, from the deepest level down:
// pass n halves boxes until none coarser than level n touches one finer than n. It does not change
// levels finer than n, so its effect on a box depends only on the boxes that touched it before the
// pass, not on the order of visits; and the effect of all passes depends only on boxes at most
// balanceReach() global boxes away; along periodic axes (RefinementSpec::periodic) also across the ends of the grid.
//
// Before the pass of a level, that of the next finer one may grow (RefinementSpec::transitionLayers): boxes that
// touch boxes of it become as fine along all axes, layer by layer: long boxes there would trouble solvers.
#pragma once

#include "Boxes/LocalBox.h"

namespace cartesian
{

// The most by which the levels of a box differ: it is at most 2^MostLevelsApart times as long as wide. A box that would
// become longer is halved along its longest sides, too.
constexpr int MostLevelsApart = 3;

// How many global boxes away a box of this depth may cause others to be halved. Each pass reaches one box further, which
// has the level of the pass in one direction: a global box in the first three passes, half one in the next, and so on.
constexpr std::uint32_t balanceReach(int depth, int transitionLayers)
{
  const int passes = depth < MostLevelsApart + 1 ? depth : MostLevelsApart + 1;
  return depth > 0
    ? static_cast<std::uint32_t>(passes * transitionLayers - (depth == passes ? 1 : 0))
    : 0;
}

// Boxes coarser than `level` are halved where they touch one of level `touching` or finer. What a pass does: balance
// a level, or let it grow.
struct BalancePass
{
  int level;
  int touching;
  bool isAlike; // boxes that are too coarse are halved along all axes
};
constexpr BalancePass balanceOf(int level, bool isAlike = false)
{
  return { level, level + 1, isAlike };
}
constexpr BalancePass growthOf(int level)
{
  return { level, level, true };
}

// A box of the fine grid, or a part of one.
struct BoxToBalance
{
  FinePoint low;
  std::array<std::uint8_t, 3> level;

  std::int64_t size(int axis) const { return FinePerBox >> level[static_cast<std::size_t>(axis)]; }
  BoxToBalance half(unsigned axis, bool upper) const
  {
    BoxToBalance result = *this;
    ++result.level[axis];
    result.low[axis] += upper ? result.size(static_cast<int>(axis)) : 0;
    return result;
  }
};

// The boxes before the pass.
class LevelsAround
{
public:
  virtual ~LevelsAround() = default;

  // The levels of the box at a place, or null. `size` receives that of a cube around it, fine, that divides
  // the grid evenly and within which the answer is the same.
  virtual const std::array<std::uint8_t, 3>* at(
    const FinePoint& fine, std::int64_t& size) const = 0;
};

// The axes (bit 1 << axis) along which a box must be halved next in a pass; its
// parts may have to be halved further. To balance, of the axes along which neighbours are too fine these are
// the ones that leave the fewest halves to be halved further, all of them if several do: thus a box
// before a wall of fine ones is first halved towards it, whichever axis that is.
unsigned axesToHalve(const LevelsAround& boxes, const BoxToBalance& box, const BalancePass& pass);

}
