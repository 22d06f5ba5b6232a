// SPDX-License-Identifier: BSD-3-Clause
// A grid of points off the surface, which blocks the lines between neighbours where it crosses them, as exactly as it winds
// around points (Surface/LineCrossings.h).
#pragma once

#include "Lattice/TriangleSlicing.h"
#include "Lattice/Vector.h"
#include "Surface/Surface.h"

namespace cartesian
{

// Points are on even levels, where no surface is; they have numbers.
class PointGrid
{
public:
  using Index = std::array<std::size_t, 3>;

  // From low to high, at most `spacing` levels apart.
  PointGrid(const Point& low, const Point& high, double spacing);

  std::size_t size() const { return lines_[0].size() * lines_[1].size() * lines_[2].size(); }

  // Blocks the lines that these cross. Polls.
  void block(const Surface& walls, Execution& execution);

  std::size_t pointAt(const Index& i) const
  {
    return i[0] + lines_[0].size() * (i[1] + lines_[1].size() * i[2]);
  }

  Index indexOf(std::size_t point) const
  {
    const std::size_t row = point / lines_[0].size();
    return { point % lines_[0].size(), row % lines_[1].size(), row / lines_[1].size() };
  }

  Vector placeOf(std::size_t point) const
  {
    const Index i = indexOf(point);
    return { double(lines_[0][i[0]]), double(lines_[1][i[1]]), double(lines_[2][i[2]]) };
  }

  bool isAtEnd(std::size_t point) const
  {
    const Index i = indexOf(point);
    bool is = false;
    for (std::size_t axis = 0; axis < 3; ++axis)
    {
      is = is || i[axis] == 0 || i[axis] + 1 == lines_[axis].size();
    }
    return is;
  }

  // Whether the line to the next point up an axis is free.
  bool isFree(std::size_t point, std::size_t axis) const
  {
    return (isBlocked_[point] >> axis & 1) == 0;
  }

  // The corners of the cell that holds a place, or is nearest to it.
  std::array<std::size_t, 8> pointsAround(const Vector& place) const;

  // Calls visit(point) for neighbours along axes and across that can be reached.
  template <class Visitor>
  void forEachNeighbour(std::size_t point, Visitor&& visit) const
  {
    const Index i = indexOf(point);
    for (int n = 0; n < 27; ++n)
    {
      const Step step{ n % 3 - 1, n / 3 % 3 - 1, n / 9 - 1 };
      std::array<std::size_t, 3> way{};
      bool isThere = n != 13;
      for (std::size_t axis = 0; axis < 3; ++axis)
      {
        isThere = isThere && !(step[axis] < 0 && i[axis] == 0) &&
          !(step[axis] > 0 && i[axis] + 1 == lines_[axis].size());
      }
      const std::size_t size = isThere ? findWay(i, step, way) : 0;
      if (size > 0)
      {
        visit(way[size - 1]);
      }
    }
  }

  // The points on the way to a neighbour, and that.
  std::vector<std::size_t> wayTo(std::size_t from, std::size_t to) const;

private:
  void block(const Corners& triangle, const RowAxes& axes);

  using Step = std::array<int, 3>;

  // Along the axes of a step, in any order; how many points it has. 0: all ways are blocked.
  std::size_t findWay(const Index& i, const Step& step, std::array<std::size_t, 3>& way) const;

  std::array<std::vector<Level>, 3> lines_;
  std::vector<std::uint8_t> isBlocked_; // of each point: the lines up the axes, as bits
};

}
