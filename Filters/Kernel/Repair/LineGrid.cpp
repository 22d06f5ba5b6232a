// SPDX-License-Identifier: BSD-3-Clause
#include "Repair/LineGrid.h"

#include "Surface/LineCrossings.h"

#include <algorithm>
#include <atomic>
#include <cmath>

namespace cartesian
{

namespace
{

constexpr std::size_t TrianglesAChunk = 512;

}

LineGrid::LineGrid(std::size_t along, const std::vector<Point>& places)
  : axes_(RowsAlong[along])
  , cells_(static_cast<std::size_t>(std::ceil(std::sqrt(double(places.size())))))
  , middle_(sideOf(places, axes_.middle))
  , outer_(sideOf(places, axes_.outer))
  , start_(cells_ * cells_ + 1)
  , lines_(places.size())
{
  std::vector<GridLine> lines;
  for (const Point& place : places)
  {
    lines.push_back({ place[static_cast<std::size_t>(axes_.middle)],
      place[static_cast<std::size_t>(axes_.outer)], static_cast<std::uint32_t>(lines.size()) });
    ++start_[cellOf(lines.back())];
  }
  scan(start_);
  std::vector<std::size_t> next = start_;
  for (const GridLine& line : lines)
  {
    lines_[next[cellOf(line)]++] = line;
  }
}

LineGrid::GridSide LineGrid::sideOf(const std::vector<Point>& places, int axis) const
{
  const auto level = static_cast<std::size_t>(axis);
  const auto [least, most] = std::minmax_element(places.begin(), places.end(),
    [&](const Point& a, const Point& b) { return a[level] < b[level]; });
  const Level low = (*least)[level];
  const Level high = (*most)[level];
  return { low, high, double(cells_) / (double(high) - low + 1) };
}

Buckets<NumberedCrossing> LineGrid::crossings(
  const Surface& surface, std::size_t most, Execution& execution) const
{
  const std::size_t count = surface.triangles.size();
  std::vector<std::vector<NumberedCrossing>> found(chunks(count, TrianglesAChunk));
  std::atomic<std::size_t> total{ 0 };
  execution.forEach(count, TrianglesAChunk, [&](std::size_t begin, std::size_t end) {
    std::vector<NumberedCrossing>& ofChunk = found[begin / TrianglesAChunk];
    for (std::size_t t = begin; t < end && total <= most; ++t)
    {
      const std::size_t before = ofChunk.size();
      cross(surface.corners(t), static_cast<std::uint32_t>(t), ofChunk);
      if (ofChunk.size() > before)
      {
        total += ofChunk.size() - before;
      }
    }
  });
  if (total > most)
  {
    return {};
  }
  return sortIntoBuckets(
    found, lines_.size(), [](const NumberedCrossing& c) { return c.line; }, execution);
}

void LineGrid::cross(
  const Corners& c, std::uint32_t triangle, std::vector<NumberedCrossing>& found) const
{
  const auto m = static_cast<std::size_t>(axes_.middle);
  const auto o = static_cast<std::size_t>(axes_.outer);
  const auto [low, high] = std::minmax({ c[0][m], c[1][m], c[2][m] });
  const auto [least, most] = std::minmax({ c[0][o], c[1][o], c[2][o] });
  if (high < middle_.low || low > middle_.high || most < outer_.low || least > outer_.high)
  {
    return;
  }
  const std::size_t first = cellAt(middle_, low);
  const std::size_t last = cellAt(middle_, high);
  const std::size_t end = cells_ * (cellAt(outer_, most) + 1);
  for (std::size_t row = cells_ * cellAt(outer_, least); row < end; row += cells_)
  {
    for (std::size_t i = start_[row + first]; i < start_[row + last + 1]; ++i)
    {
      const GridLine& line = lines_[i];
      const bool isBeside = (line.middle < low) | (line.middle > high) | (line.outer < least) |
        (line.outer > most); // without branches, which would be mispredicted
      if (isBeside)
      {
        continue;
      }
      const CrossedLevels crossed = crossedLevels(c, axes_, line.outer);
      if (line.middle >= crossed.from && line.middle < crossed.to)
      {
        Point at{};
        at[m] = line.middle;
        at[o] = line.outer;
        const auto along = static_cast<std::size_t>(axes_.along);
        found.push_back(
          { { crossLine(c, axes_.along, at)[along], triangle, crossed.up }, line.number });
      }
    }
  }
}

}
