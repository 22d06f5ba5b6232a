// SPDX-License-Identifier: BSD-3-Clause
// A grid that goes on beyond its ends, along some axes, with the boxes at its other ends: so balance sees it
// (RefinementSpec::periodic).
#pragma once

#include "Lattice/Meshlines.h"

#include <array>
#include <bitset>
#include <cstdint>

namespace cartesian
{

// Bit n: along axis n.
using PeriodicAxes = std::bitset<3>;

class EndlessGrid
{
public:
  EndlessGrid() = default; // it ends along all axes
  EndlessGrid(const PeriodicAxes& axes, const Meshlines& planes)
  {
    for (std::size_t axis = 0; axis < 3; ++axis)
    {
      period_[axis] = axes[axis] ? static_cast<std::int64_t>(planes[axis].size()) - 1 : 0;
    }
  }

  // The indices of the global box that is seen at `at`, which is at most a whole grid beyond the ends. Along other
  // axes they stay.
  std::array<std::int64_t, 3> seen(std::array<std::int64_t, 3> at) const
  {
    for (std::size_t axis = 0; axis < 3; ++axis)
    {
      at[axis] = period_[axis] == 0 ? at[axis] : (at[axis] + period_[axis]) % period_[axis];
    }
    return at;
  }

private:
  std::array<std::int64_t, 3> period_{}; // in global boxes; 0: it ends
};

}
