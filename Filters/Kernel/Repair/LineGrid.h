// SPDX-License-Identifier: BSD-3-Clause
// Finds the lines along one axis that cross a triangle: a grid across that axis lists the lines in
// each cell.
#pragma once

#include "Repair/SampleRays.h"
#include "Surface/LineCrossings.h"

namespace cartesian
{

class LineGrid
{
public:
  // Borrows `lines`, sorts them, and drops the last ones if the surface's triangles would have to
  // be tested against too many.
  LineGrid(const Surface& surface, int along, std::vector<SampleRay>& lines, Execution& execution);

  // Calls visit(line) with the numbers of the lines that cross a triangle.
  template <class Visitor>
  void forEachLine(const Corners& c, Visitor&& visit) const
  {
    const auto [least, most] =
      std::minmax({ c[0][axes_.outer], c[1][axes_.outer], c[2][axes_.outer] });
    const CellRange range = rangeOf(c);
    for (std::size_t o = range.first[1]; o < range.end[1]; ++o)
    {
      for (std::size_t m = range.first[0]; m < range.end[0]; ++m)
      {
        const std::size_t cell = m + o * cells_;
        for (std::size_t i = start_[cell]; i < start_[cell + 1]; ++i)
        {
          const SampleRay& line = lines_[number_[i]];
          if (line.outer > least && line.outer < most)
          {
            const auto [from, to, up] = crossedLevels(c, axes_, line.outer);
            if (line.middle > from && line.middle < to)
            {
              visit(number_[i]);
            }
          }
        }
      }
    }
  }

  Point at(std::uint32_t line) const
  {
    Point p{};
    p[axes_.middle] = lines_[line].middle;
    p[axes_.outer] = lines_[line].outer;
    return p;
  }

private:
  struct CellRange
  {
    std::array<std::size_t, 2> first{ 0, 0 };
    std::array<std::size_t, 2> end{ 0, 0 };
  };

  std::size_t cellAt(std::size_t direction, double level) const;
  CellRange rangeOf(const Corners& c) const;
  void fileLines();
  double tests(const Surface& surface, Execution& execution) const;

  const RowAxes axes_;
  std::vector<SampleRay>& lines_;
  std::size_t cells_ = 1; // in each direction
  std::array<double, 2> low_{};
  std::array<double, 2> size_{};
  std::vector<std::size_t> start_;    // of each cell in number_, and the end
  std::vector<std::uint32_t> number_; // of the lines in each cell
};

}
