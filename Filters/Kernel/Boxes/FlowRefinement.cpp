// SPDX-License-Identifier: BSD-3-Clause
#include "Boxes/FlowRefinement.h"

#include "Base/Error.h"
#include "Boxes/Boxes.h"

#include <algorithm>
#include <cmath>

namespace cartesian
{

namespace
{

// In lengths of the bodies' longest side: how far the zones reach beyond them, and the wake behind them.
constexpr double Margin = 0.25;
constexpr double WakeLength = 2;

// Boxes around the bodies are as large again as along them, and in the wake once more. But a zone is a box: finer ones
// than these would fill it with far more boxes than the wall has, and Transition Layers lie between. A zone of this depth,
// or with so many boxes along the bodies, is fine enough.
struct FineEnough
{
  int depth;
  int boxesAlong;
};

constexpr FineEnough AroundBodies{ 5, 60 };
constexpr FineEnough InTheWake{ 4, 30 };

Bounds common(Bounds a, const Bounds& b)
{
  for (std::size_t axis = 0; axis < 3; ++axis)
  {
    a.low[axis] = std::max(a.low[axis], b.low[axis]);
    a.high[axis] = std::min(a.high[axis], b.high[axis]);
  }
  return a;
}

Bounds grown(Bounds box, double by)
{
  for (std::size_t axis = 0; axis < 3; ++axis)
  {
    box.low[axis] -= by;
    box.high[axis] += by;
  }
  return box;
}

// The longest edge of a box of the grid that reaches into `body`.
double largestBox(const GridSpec& grid, const Bounds& body)
{
  double largest = 0;
  for (std::size_t axis = 0; axis < 3; ++axis)
  {
    const std::vector<double>& lines = grid.meshlines[axis];
    for (std::size_t i = 0; i + 1 < lines.size(); ++i)
    {
      if (lines[i] < body.high[axis] && lines[i + 1] > body.low[axis])
      {
        largest = std::max(largest, lines[i + 1] - lines[i]);
      }
    }
  }
  return largest;
}

// `largest`: the longest edge of undivided boxes along the bodies.
int fineEnough(const FineEnough& zone, double largest, double length)
{
  int depth = zone.depth;
  while (depth < DeepestLevel && std::ldexp(largest, -depth) * zone.boxesAlong > length)
  {
    ++depth;
  }
  return depth;
}

}

FlowRefinement flowRefinement(const DomainSpec& domain, const GridSpec& grid, const Bounds& surface)
{
  requireInRange(DomainSpec::BoxesAlong, domain.boxesAlong, "Boxes Along Body");
  const Bounds box = boxAround(domain, surface);
  const Bounds body = common(surface, box);
  const double length = body.longest();
  FlowRefinement result;
  result.length = length;
  const double largest = largestBox(fittedTo(box, grid), body);
  result.size = largest;
  while (!result.hasAlong(domain.boxesAlong) && result.depth < DeepestLevel)
  {
    result.size /= 2;
    ++result.depth;
  }
  const Bounds around = grown(body, Margin * length);
  Bounds wake = around;
  const auto flow = static_cast<std::size_t>(domain.flow);
  (flow % 2 == 0 ? wake.high : wake.low)[flow / 2] +=
    (flow % 2 == 0 ? 1 : -1) * (WakeLength - Margin) * length;
  for (const FlowZone& zone :
    { FlowZone{ around, std::min(result.depth - 1, fineEnough(AroundBodies, largest, length)) },
      FlowZone{ wake, std::min(result.depth - 2, fineEnough(InTheWake, largest, length)) } })
  {
    if (zone.depth > 0)
    {
      result.zones.push_back({ common(zone.box, box), zone.depth });
    }
  }
  return result;
}

}
