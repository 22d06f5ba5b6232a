// SPDX-License-Identifier: BSD-3-Clause
// The sides of a flow domain, which no point moves through when layers are made.
#pragma once

#include "Boxes/Boxes.h"
#include "Lattice/Vector.h"
#include "Surface/Surface.h"

#include <cmath>

namespace cartesian
{

class FlowDomainSides
{
public:
  // The ends of the grid, if the domain is the space around the surface; otherwise none.
  FlowDomainSides(const Boxes& boxes, const Surface& surface);

  // A way from a point on a side does not lead out there.
  Vector along(const Vector& from, Vector way) const;

  // Where a way leaves through one that it does not begin on, in its own length; more than 1: it does not.
  double leavesAt(const Vector& from, const Vector& way) const;

  // The way, or as much of it as leads at most half the way to a side.
  Vector within(const Vector& from, const Vector& way) const;

private:
  // From a point to the side that a way leads towards.
  double left(const Vector& from, const Vector& way, std::size_t axis) const
  {
    return std::abs(ends_[way[axis] < 0 ? 0 : 1][axis] - from[axis]);
  }

  std::array<Vector, 2> ends_; // in user units
  double nearby_;              // half a level: on the side
};

}
