// SPDX-License-Identifier: BSD-3-Clause
#include "Repair/RayCrossings.h"

#include "Surface/LineCrossings.h"

#include <algorithm>
#include <limits>

namespace cartesian
{

std::vector<RayCrossing> crossingsOf(
  const Surface& surface, const TriangleTree& tree, std::size_t along, const Point& place)
{
  const RowAxes& axes = RowsAlong[along];
  const std::vector<Level> middles{ place[static_cast<std::size_t>(axes.middle)] };
  const std::vector<Level> outers{ place[static_cast<std::size_t>(axes.outer)] };
  Vector low = toVector(place);
  Vector high = low;
  low[along] = 0;
  high[along] = std::numeric_limits<Level>::max();
  std::vector<RayCrossing> crossings;
  tree.forEachWithin(low, high, [&](std::uint32_t t) {
    forEachLineCrossing(surface.corners(t), axes, middles, outers,
      [&](std::size_t, std::size_t, const Point& p, bool up) {
        crossings.push_back({ p[along], t, up });
      });
  });
  std::sort(crossings.begin(), crossings.end());
  return crossings;
}

}
