// SPDX-License-Identifier: BSD-3-Clause
#include "Surface/LineCrossings.h"

namespace cartesian
{

namespace
{

constexpr std::size_t TrianglesAChunk = 2048;
constexpr std::size_t LinesAChunk = 1024;

}

LineCrossings::LineCrossings(
  const Surface& surface, const Meshlines& planes, int along, Execution& execution)
  : axes_(RowsAlong[static_cast<std::size_t>(along)])
  , around_(surface.around)
  , linesOfMiddle_(planes[axes_.middle].size())
{
  const std::size_t count = surface.triangles.size();
  std::vector<std::vector<LineCrossing>> found(chunks(count, TrianglesAChunk));
  execution.forEach(count, TrianglesAChunk, [&](std::size_t begin, std::size_t end) {
    auto& crossings = found[begin / TrianglesAChunk];
    for (std::size_t t = begin; t < end; ++t)
    {
      forEachLineCrossing(surface.corners(t), axes_, planes[axes_.middle], planes[axes_.outer],
        [&](std::size_t middle, std::size_t outer, const Point& p, bool up) {
          const std::int64_t below = intervalOf(planes[axes_.along], p[axes_.along]) + 1;
          crossings.push_back({ static_cast<std::uint32_t>(middle + outer * linesOfMiddle_),
            static_cast<std::uint32_t>(below), surface.crossing(t, up) });
        });
    }
  });
  crossings_ = sortIntoBuckets(
    found, linesOfMiddle_ * planes[axes_.outer].size(),
    [](const LineCrossing& c) { return c.line; }, execution);
  execution.forEach(
    crossings_.start.size() - 1, LinesAChunk, [&](std::size_t begin, std::size_t end) {
      for (std::size_t line = begin; line < end; ++line)
      {
        for (std::size_t i = crossings_.start[line] + 1; i < crossings_.start[line + 1]; ++i)
        {
          crossings_.items[i].winding.add(crossings_.items[i - 1].winding);
        }
      }
    });
}

}
