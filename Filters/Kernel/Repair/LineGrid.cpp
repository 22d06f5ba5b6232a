// SPDX-License-Identifier: BSD-3-Clause
#include "Repair/LineGrid.h"

#include "Base/Sorting.h"

#include <algorithm>
#include <cmath>
#include <numeric>

namespace cartesian
{

namespace
{

// Tests of a line against a triangle in all. Beyond that, lines are dropped, those of small
// triangles first: millions of large triangles that all overlap would take days.
constexpr double MostTests = 5e6;
constexpr double LeastReduction = 1.25; // of the number of lines in one step

constexpr std::size_t TrianglesAChunk = 4096;

constexpr double MostGridCells = 1024; // in each direction

}

LineGrid::LineGrid(
  const Surface& surface, int along, std::vector<SampleRay>& lines, Execution& execution)
  : axes_(RowsAlong[static_cast<std::size_t>(along)])
  , lines_(lines)
{
  std::sort(lines_.begin(), lines_.end());
  Bounds bounds = Bounds::none();
  for (const SampleRay& line : lines_)
  {
    bounds.include(0, line.middle);
    bounds.include(1, line.outer);
  }
  low_ = { bounds.low[0], bounds.low[1] };
  for (std::size_t i = 0; i < 2; ++i)
  {
    size_[i] = std::max(bounds.high[i] - bounds.low[i], 1.0);
  }
  double excess = 1;
  while (fileLines(), excess = tests(surface, execution) / MostTests, excess > 1)
  {
    lines_.resize(static_cast<std::size_t>(
      static_cast<double>(lines_.size()) / std::max(excess, LeastReduction)));
  }
}

std::size_t LineGrid::cellAt(std::size_t direction, double level) const
{
  const double cell = (level - low_[direction]) / size_[direction] * static_cast<double>(cells_);
  return static_cast<std::size_t>(std::clamp(cell, 0.0, static_cast<double>(cells_ - 1)));
}

LineGrid::CellRange LineGrid::rangeOf(const Corners& c) const
{
  CellRange range;
  for (std::size_t i = 0; i < 2; ++i)
  {
    const int axis = i == 0 ? axes_.middle : axes_.outer;
    const auto [least, most] = std::minmax({ c[0][axis], c[1][axis], c[2][axis] });
    if (most < low_[i] || least > low_[i] + size_[i])
    {
      return {};
    }
    range.first[i] = cellAt(i, least);
    range.end[i] = cellAt(i, most) + 1;
  }
  return range;
}

void LineGrid::fileLines()
{
  const auto count = static_cast<double>(lines_.size());
  cells_ = static_cast<std::size_t>(std::clamp(std::sqrt(count), 1.0, MostGridCells));
  start_.assign(cells_ * cells_ + 1, 0);
  const auto cellOf = [&](const SampleRay& line) {
    return cellAt(0, line.middle) + cells_ * cellAt(1, line.outer);
  };
  for (const SampleRay& line : lines_)
  {
    ++start_[cellOf(line)];
  }
  number_.resize(scan(start_));
  std::vector<std::size_t> next(start_.begin(), start_.end() - 1);
  for (std::size_t n = 0; n < lines_.size(); ++n)
  {
    number_[next[cellOf(lines_[n])]++] = static_cast<std::uint32_t>(n);
  }
}

// How many lines and cells all triangles together would be tested against.
double LineGrid::tests(const Surface& surface, Execution& execution) const
{
  // Summed-area table: the lines in all cells left of and below each corner of a cell.
  const std::size_t corners = cells_ + 1;
  std::vector<std::size_t> below(corners * corners);
  for (std::size_t o = 0; o < cells_; ++o)
  {
    for (std::size_t m = 0; m < cells_; ++m)
    {
      const std::size_t at = m + o * corners;
      const std::size_t here = start_[m + o * cells_ + 1] - start_[m + o * cells_];
      below[at + corners + 1] = here + below[at + corners] + below[at + 1] - below[at];
    }
  }
  const std::size_t count = surface.triangles.size();
  std::vector<std::size_t> sums(chunks(count, TrianglesAChunk));
  execution.forEach(count, TrianglesAChunk, [&](std::size_t begin, std::size_t end) {
    for (std::size_t t = begin; t < end; ++t)
    {
      const CellRange range = rangeOf(surface.corners(t));
      const std::size_t low = range.first[1] * corners;
      const std::size_t high = range.end[1] * corners;
      sums[begin / TrianglesAChunk] +=
        (range.end[0] - range.first[0]) * (range.end[1] - range.first[1]) +
        below[range.end[0] + high] - below[range.first[0] + high] - below[range.end[0] + low] +
        below[range.first[0] + low];
    }
  });
  return static_cast<double>(std::accumulate(sums.begin(), sums.end(), std::size_t(0)));
}

}
