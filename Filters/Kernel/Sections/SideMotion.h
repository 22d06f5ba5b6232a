// SPDX-License-Identifier: BSD-3-Clause
// How one side of a mesh comes to lie on another: turned around an axis, then moved.
#pragma once

#include "Lattice/Vector.h"

namespace cartesian
{

struct SideMotion
{
  Vector translation{};
  Vector axis{ 1, 0, 0 }; // of length 1
  Vector centre{};        // a point on it
  double angle = 0;       // degrees, right-handed

  Vector of(const Vector& point) const { return plus(turned(point, angle), translation); }
  Vector before(const Vector& point) const { return turned(minus(point, translation), -angle); }

  // A motion that either turns or moves.
  SideMotion reversed() const { return { scaled(translation, -1), axis, centre, -angle }; }

  // In other units.
  SideMotion enlarged(double scale) const
  {
    return { scaled(translation, scale), axis, scaled(centre, scale), angle };
  }

private:
  Vector turned(const Vector& point, double by) const
  {
    if (by == 0)
    {
      return point;
    }
    const Vector from = minus(point, centre);
    const Vector along = scaled(axis, dot(axis, from));
    const Vector across = minus(from, along);
    const Vector turnedAcross = plus(
      scaled(across, std::cos(radians(by))), scaled(cross(axis, across), std::sin(radians(by))));
    return plus(centre, plus(along, turnedAcross));
  }
};

}
