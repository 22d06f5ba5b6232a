// SPDX-License-Identifier: BSD-3-Clause
// The triangles at one edge, in the order in which they stand around it. Decided exactly.
#pragma once

#include "Base/Rings.h"
#include "Repair/TrianglePlane.h"

#include <algorithm>
#include <array>
#include <cstdint>
#include <vector>

namespace cartesian
{

class RadialEdgeSort
{
public:
  // `vertices`: all places, by number.
  explicit RadialEdgeSort(const std::vector<Point>& vertices)
    : vertices_(vertices)
  {
  }

  struct IncidentTriangle
  {
    std::uint32_t triangle;
    std::uint32_t apex;
    bool down; // it runs from the upper end of the edge to the lower
    int half;  // from the first: 0 there, 1 before half a turn, 2 there, 3 beyond
  };

  void start(std::uint32_t lower, std::uint32_t upper)
  {
    blades_.clear();
    lower_ = lower;
    upper_ = upper;
  }

  void add(std::uint32_t triangle, const std::array<std::uint32_t, 3>& v, bool down)
  {
    blades_.push_back({ triangle, v[0] ^ v[1] ^ v[2] ^ lower_ ^ upper_, down, 0 });
  }

  // Calls visit(one, next) for each space between neighbours: it is in front of `one` if that runs up the edge, and of
  // `next` if that runs down.
  template <class Visitor>
  void forEachSpace(Visitor&& visit)
  {
    if (blades_.size() > 2)
    {
      sort();
    }
    for (std::size_t i = 0; i < blades_.size(); ++i)
    {
      visit(blades_[i], following(blades_, i));
    }
  }

  // Whether two lie on each other.
  bool coincide(const IncidentTriangle& one, const IncidentTriangle& other) const
  {
    return turnTo(one.apex, other.apex) == 0 && isAlong(one.apex, other.apex);
  }

private:
  void sort()
  {
    const std::uint32_t first = blades_.front().apex;
    for (IncidentTriangle& blade : blades_)
    {
      const int turn = turnTo(first, blade.apex);
      blade.half = turn > 0 ? 1 : (turn < 0 ? 3 : (isAlong(first, blade.apex) ? 0 : 2));
    }
    std::sort(
      blades_.begin(), blades_.end(), [&](const IncidentTriangle& a, const IncidentTriangle& b) {
        const int turn = a.half != b.half ? b.half - a.half : turnTo(a.apex, b.apex);
        return turn != 0 ? turn > 0 : a.triangle < b.triangle;
      });
  }

  // 1 if the half plane of apex b is reached from that of a by less than half a turn to the left, seen against the
  // edge's direction.
  int turnTo(std::uint32_t a, std::uint32_t b) const
  {
    return orientation(vertices_[lower_], vertices_[upper_], vertices_[a], vertices_[b]);
  }

  // Whether two apexes in one plane with the edge are on the same side of it.
  bool isAlong(std::uint32_t a, std::uint32_t b) const
  {
    for (int axis = 0; axis < 3; ++axis)
    {
      const auto at = [&](std::uint32_t v) { return flatten(vertices_[v], axis); };
      const int x = sign(turn(at(lower_), at(upper_), at(a)));
      const int y = sign(turn(at(lower_), at(upper_), at(b)));
      if (x != 0 && y != 0)
      {
        return x == y;
      }
    }
    return true;
  }

  const std::vector<Point>& vertices_;
  std::uint32_t lower_ = 0;
  std::uint32_t upper_ = 0;
  std::vector<IncidentTriangle> blades_;
};

}
