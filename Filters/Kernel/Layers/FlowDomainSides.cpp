// SPDX-License-Identifier: BSD-3-Clause
#include "Layers/FlowDomainSides.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace cartesian
{

FlowDomainSides::FlowDomainSides(const Boxes& boxes, const Surface& surface)
  : nearby_(boxes.lattice.step() / 2)
{
  constexpr double Far = std::numeric_limits<double>::infinity();
  ends_ = { Vector{ -Far, -Far, -Far }, Vector{ Far, Far, Far } };
  for (std::size_t axis = 0; surface.around.inside() && axis < 3; ++axis)
  {
    const auto& planes = boxes.planes[axis];
    ends_[0][axis] = boxes.lattice.position(static_cast<int>(axis), planes.front());
    ends_[1][axis] = boxes.lattice.position(static_cast<int>(axis), planes.back());
  }
}

double FlowDomainSides::leavesAt(const Vector& from, const Vector& way) const
{
  double least = 2;
  for (std::size_t axis = 0; axis < 3; ++axis)
  {
    const double length = left(from, way, axis);
    if (length > nearby_ && length < least * std::abs(way[axis]))
    {
      least = length / std::abs(way[axis]);
    }
  }
  return least;
}

Vector FlowDomainSides::along(const Vector& from, Vector way) const
{
  for (std::size_t axis = 0; axis < 3; ++axis)
  {
    way[axis] = left(from, way, axis) > nearby_ ? way[axis] : 0;
  }
  return way;
}

Vector FlowDomainSides::within(const Vector& from, const Vector& way) const
{
  constexpr double MostOfTheWay = 0.5;
  const Vector inside = along(from, way);
  return scaled(inside, std::min(1.0, MostOfTheWay * leavesAt(from, inside)));
}

}
