// SPDX-License-Identifier: BSD-3-Clause
// A bounding volume hierarchy of triangles: which of them are near each other, or a place?
//
// Triangles are sorted along a space-filling curve (Morton order); a node of height h holds 2^h
// consecutive ones. The tree depends on the geometry only, except that ties are broken by the
// triangles' numbers.
#pragma once

#include "Lattice/Vector.h"
#include "Surface/Surface.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace cartesian
{

class TriangleTree
{
public:
  // Of those that have an area.
  TriangleTree(const Surface& surface, Execution& execution);

  // Of some, whether or not they have an area.
  TriangleTree(const Surface& surface, std::vector<std::uint32_t> triangles, Execution& execution);

  std::size_t size() const { return order_.size(); }
  std::uint32_t triangle(std::size_t place) const { return order_[place]; }

  // Calls visit(triangle) for triangles whose bounds meet those of the triangle at `place` and that
  // are larger, or of the same size and later on the curve, until visit returns false. So each pair
  // is visited once, and in few visits per triangle: a triangle has few larger neighbours.
  template <class Visitor>
  void forEachLarger(std::size_t place, Visitor&& visit) const
  {
    const TreeNode& own = levels_[0][place];
    std::array<std::pair<std::size_t, std::size_t>, 2 * MostLevels> stack; // level, node
    std::size_t size = 0;
    stack[size++] = { levels_.size() - 1, 0 };
    while (size > 0)
    {
      const auto [level, n] = stack[--size];
      if (level == 0)
      {
        if ((levels_[0][n].size > own.size || n > place) && !visit(order_[n]))
        {
          return;
        }
        continue;
      }
      const std::vector<TreeNode>& below = levels_[level - 1];
      for (std::size_t child = std::min(2 * n + 2, below.size()); child-- > 2 * n;)
      {
        if (below[child].size >= own.size && below[child].meets(own))
        {
          stack[size++] = { level - 1, child };
        }
      }
    }
  }

  // Calls visit(triangle) for triangles whose bounds meet these, in levels; along the curve.
  template <class Visitor>
  void forEachWithin(const Vector& low, const Vector& high, Visitor&& visit) const
  {
    std::array<std::pair<std::size_t, std::size_t>, 2 * MostLevels> stack; // level, node
    std::size_t size = 0;
    stack[size++] = { levels_.size() - 1, 0 };
    while (size > 0)
    {
      const auto [level, n] = stack[--size];
      if (n >= levels_[level].size() || !levels_[level][n].meets(low, high))
      {
        continue;
      }
      if (level == 0)
      {
        visit(order_[n]);
        continue;
      }
      stack[size++] = { level - 1, 2 * n + 1 };
      stack[size++] = { level - 1, 2 * n };
    }
  }

  // The triangle with the least distance(triangle), in levels, from a place; of equally near ones the first along the curve. There
  // must be one.
  template <class Distance>
  std::uint32_t nearest(const Vector& place, Distance&& distance) const
  {
    std::array<std::pair<std::size_t, std::size_t>, 2 * MostLevels> stack; // level, node
    std::size_t size = 0;
    stack[size++] = { levels_.size() - 1, 0 };
    double least = std::numeric_limits<double>::infinity();
    std::uint32_t best = order_.front();
    while (size > 0)
    {
      const auto [level, n] = stack[--size];
      if (n >= levels_[level].size() || levels_[level][n].distanceTo(place) >= least)
      {
        continue;
      }
      if (level == 0)
      {
        const double d = distance(order_[n]);
        best = d < least ? order_[n] : best;
        least = std::min(least, d);
        continue;
      }
      const std::vector<TreeNode>& below = levels_[level - 1];
      const bool isSecondNearer = 2 * n + 1 < below.size() &&
        below[2 * n + 1].distanceTo(place) < below[2 * n].distanceTo(place);
      stack[size++] = { level - 1, 2 * n + (isSecondNearer ? 0 : 1) };
      stack[size++] = { level - 1, 2 * n + (isSecondNearer ? 1 : 0) };
    }
    return best;
  }

private:
  static constexpr std::size_t MostLevels = 34;

  struct TreeNode
  {
    Point low;
    Point high;
    Level size; // the longest side of the largest triangle's bounds

    bool meets(const TreeNode& other) const
    {
      return low[0] <= other.high[0] && other.low[0] <= high[0] && low[1] <= other.high[1] &&
        other.low[1] <= high[1] && low[2] <= other.high[2] && other.low[2] <= high[2];
    }

    bool meets(const Vector& from, const Vector& to) const
    {
      return low[0] <= to[0] && from[0] <= high[0] && low[1] <= to[1] && from[1] <= high[1] &&
        low[2] <= to[2] && from[2] <= high[2];
    }

    double distanceTo(const Vector& place) const
    {
      double square = 0;
      for (std::size_t axis = 0; axis < 3; ++axis)
      {
        const double beyond =
          std::max({ low[axis] - place[axis], place[axis] - double(high[axis]), 0.0 });
        square += beyond * beyond;
      }
      return std::sqrt(square);
    }
  };

  static TreeNode leafOf(const Corners& c);
  void addLevel(Execution& execution);

  std::vector<std::uint32_t> order_;          // triangles along the curve
  std::vector<std::vector<TreeNode>> levels_; // from the triangles up to the root
};

}
