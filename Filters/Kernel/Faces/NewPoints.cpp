// SPDX-License-Identifier: BSD-3-Clause
#include "Faces/NewPoints.h"

namespace cartesian
{

std::uint32_t NewPoints::add(const Point& p)
{
  if (byPlace_.empty())
  {
    for (std::uint32_t node = 0; node < nodes_.patchPoints; ++node)
    {
      byPlace_.emplace_hint(byPlace_.end(), nodes_.at[node], node);
    }
  }
  const auto next = static_cast<std::uint32_t>(nodes_.at.size() + points_.size());
  const auto [place, isNew] = byPlace_.emplace(p, next);
  if (isNew)
  {
    points_.push_back(p);
  }
  return place->second;
}

std::uint32_t NewPoints::addMiddle(std::uint32_t low, std::uint32_t high)
{
  Point p = at(low);
  for (std::size_t axis = 0; axis < 3; ++axis)
  {
    p[axis] = p[axis] == at(high)[axis] ? p[axis] : oddMiddle(p[axis], at(high)[axis]);
  }
  return add(p);
}

}
