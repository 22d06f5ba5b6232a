// SPDX-License-Identifier: BSD-3-Clause
// Points that rebuilding flawed boxes adds, numbered after the nodes.
#pragma once

#include "Faces/Nodes.h"

#include <map>

namespace cartesian
{

class NewPoints
{
public:
  explicit NewPoints(const Nodes& nodes)
    : nodes_(nodes)
  {
  }

  // The place of a node or of a new point.
  const Point& at(std::uint32_t node) const
  {
    return node < nodes_.at.size() ? nodes_.at[node] : points_[node - nodes_.at.size()];
  }

  // The number of the point at a place, where a patch may already have a corner.
  std::uint32_t add(const Point& p);

  // Adds the point in the middle of two others along each axis, but off all cutting planes that do not
  // have both.
  std::uint32_t addMiddle(std::uint32_t low, std::uint32_t high);

  const std::vector<Point>& points() const { return points_; }

private:
  const Nodes& nodes_;
  std::vector<Point> points_;
  std::map<Point, std::uint32_t> byPlace_; // corners of patches and new points
};

// The odd level, off all cutting planes, in the middle of two levels.
inline Level oddMiddle(Level a, Level b)
{
  const Level low = std::min(a, b);
  return (low + (std::max(a, b) - low) / 2) | 1;
}

}
