// SPDX-License-Identifier: BSD-3-Clause
// Where many axis-parallel lines cross the triangles of a surface: a grid across the lines lists those in each cell, and
// each triangle is looked up in it once. For few lines the tree is faster (RayCrossings.h).
#pragma once

#include "Lattice/TriangleSlicing.h"
#include "Repair/RayCrossings.h"

namespace cartesian
{

class LineGrid
{
public:
  // Of the lines along an axis through these places, whose other two levels are even. There is at least one.
  LineGrid(std::size_t along, const std::vector<Point>& places);

  // By line, in order. None, if there are more than `most`.
  Buckets<NumberedCrossing> crossings(
    const Surface& surface, std::size_t most, Execution& execution) const;

private:
  struct GridLine
  {
    Level middle;
    Level outer;
    std::uint32_t number;
  };

  struct GridSide
  {
    Level low;
    Level high;
    double cellsPerLevel;
  };

  std::size_t cellAt(const GridSide& side, Level level) const
  {
    const Level beyond = std::clamp(level, side.low, side.high) - side.low;
    return static_cast<std::size_t>(beyond * side.cellsPerLevel);
  }
  std::size_t cellOf(const GridLine& line) const
  {
    return cellAt(middle_, line.middle) + cells_ * cellAt(outer_, line.outer);
  }
  GridSide sideOf(const std::vector<Point>& places, int axis) const;
  void cross(
    const Corners& corners, std::uint32_t triangle, std::vector<NumberedCrossing>& found) const;

  RowAxes axes_;
  std::size_t cells_; // in each direction
  GridSide middle_;
  GridSide outer_;
  std::vector<std::size_t> start_; // of each cell's lines, and the end
  std::vector<GridLine> lines_;
};

}
