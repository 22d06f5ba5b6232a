// SPDX-License-Identifier: BSD-3-Clause
#include "Repair/RayCrossings.h"

#include "Repair/LineGrid.h"
#include "Surface/LineCrossings.h"

#include <algorithm>
#include <limits>

namespace cartesian
{

namespace
{

// A look-up of one triangle in a grid of lines takes about a thousandth of the time of one line in the tree.
constexpr std::size_t TrianglesALine = 1024;

constexpr std::size_t MostAtOnce = 10000000;
constexpr std::size_t LinesAnyway = 1024;
constexpr std::size_t AnyNumber = std::numeric_limits<std::size_t>::max();

Buckets<NumberedCrossing> crossingsByTree(const Surface& surface, const TriangleTree& tree,
  std::size_t along, const std::vector<Point>& places, Execution& execution)
{
  std::vector<std::vector<NumberedCrossing>> found(places.size());
  execution.forEach(places.size(), 1, [&](std::size_t i, std::size_t) {
    for (const RayCrossing& crossing : crossingsOf(surface, tree, along, places[i]))
    {
      found[i].push_back({ crossing, static_cast<std::uint32_t>(i) });
    }
  });
  return sortIntoBuckets(
    found, places.size(), [](const NumberedCrossing& c) { return c.line; }, execution);
}

}

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

Buckets<NumberedCrossing> crossingsOf(const Surface& surface, const TriangleTree& tree,
  std::size_t along, std::vector<Point>& places, Execution& execution)
{
  if (places.size() * TrianglesALine < surface.triangles.size())
  {
    return crossingsByTree(surface, tree, along, places, execution);
  }
  const std::size_t most = places.size() > LinesAnyway ? MostAtOnce : AnyNumber;
  Buckets<NumberedCrossing> crossings = LineGrid(along, places).crossings(surface, most, execution);
  if (crossings.start.empty())
  {
    places.resize(LinesAnyway);
    crossings = LineGrid(along, places).crossings(surface, AnyNumber, execution);
  }
  return crossings;
}

}
