// SPDX-License-Identifier: BSD-3-Clause
// Points in a plane, halved again and again: which of them are near a segment?
#pragma once

#include "Lattice/Plane.h"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <vector>

namespace cartesian
{

class PointTree
{
public:
  explicit PointTree(const std::vector<PlanePoint>& points)
    : points_(points)
    , order_(points.size())
  {
    std::iota(order_.begin(), order_.end(), 0);
    add(0, static_cast<std::uint32_t>(order_.size()));
  }

  // Calls visit(number) for the points within a distance of a segment, and some others.
  template <class Visitor>
  void forEachNear(
    const PlanePoint& from, const PlanePoint& to, double distance, Visitor&& visit) const
  {
    const double margin =
      distance * std::hypot(static_cast<double>(to.a - from.a), static_cast<double>(to.b - from.b));
    for (std::size_t n = 0; n < nodes_.size();)
    {
      const Node& node = nodes_[n];
      if (!node.isNear(from, to, distance, margin))
      {
        n = node.next;
        continue;
      }
      for (std::uint32_t i = node.begin; node.next == n + 1 && i < node.end; ++i)
      {
        visit(order_[i]);
      }
      ++n;
    }
  }

private:
  static constexpr std::uint32_t MostOfALeaf = 8;

  struct Node
  {
    std::uint32_t begin; // in order_
    std::uint32_t end;
    std::size_t next; // behind those below it
    PlanePoint low;
    PlanePoint high;

    bool isNear(const PlanePoint& from, const PlanePoint& to, double distance, double margin) const
    {
      const auto isApart = [&](std::int64_t least, std::int64_t most, std::int64_t p,
                             std::int64_t q) {
        return static_cast<double>(least - std::max(p, q)) > distance ||
          static_cast<double>(std::min(p, q) - most) > distance;
      };
      if (isApart(low.a, high.a, from.a, to.a) || isApart(low.b, high.b, from.b, to.b))
      {
        return false;
      }
      const auto side = [&](std::int64_t a, std::int64_t b) {
        const auto area = static_cast<double>(turn(from, to, { a, b }));
        return area > margin ? 1 : (area < -margin ? -1 : 0);
      };
      return std::abs(side(low.a, low.b) + side(low.a, high.b) + side(high.a, low.b) +
               side(high.a, high.b)) < 4;
    }
  };

  void add(std::uint32_t begin, std::uint32_t end)
  {
    const std::size_t n = nodes_.size();
    Node node{ begin, end, 0, points_[order_[begin]], points_[order_[begin]] };
    for (std::uint32_t i = begin; i < end; ++i)
    {
      const PlanePoint& p = points_[order_[i]];
      node.low = { std::min(node.low.a, p.a), std::min(node.low.b, p.b) };
      node.high = { std::max(node.high.a, p.a), std::max(node.high.b, p.b) };
    }
    nodes_.push_back(node);
    if (end - begin > MostOfALeaf)
    {
      const bool isWide = node.high.a - node.low.a >= node.high.b - node.low.b;
      const std::uint32_t middle = begin + (end - begin) / 2;
      std::nth_element(order_.begin() + begin, order_.begin() + middle, order_.begin() + end,
        [&](std::uint32_t i, std::uint32_t j) {
          return isWide ? points_[i].a < points_[j].a : points_[i].b < points_[j].b;
        });
      add(begin, middle);
      add(middle, end);
    }
    nodes_[n].next = nodes_.size();
  }

  const std::vector<PlanePoint>& points_;
  std::vector<std::uint32_t> order_;
  std::vector<Node> nodes_; // each before those below it
};

}
