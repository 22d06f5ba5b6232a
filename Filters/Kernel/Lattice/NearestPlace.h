// SPDX-License-Identifier: BSD-3-Clause
// The place of a triangle nearest to another place, in double precision: for measures, never for exact decisions.
#pragma once

#include "Lattice/Crossing.h"
#include "Lattice/Vector.h"

namespace cartesian
{

// Ericson, Real-Time Collision Detection, 5.1.5: by the regions of the triangle's plane. The triangle may have no area, and
// edges without length, which have no region.
inline Vector nearestPlace(const Vector& a, const Vector& b, const Vector& c, const Vector& place)
{
  const auto share = [](double part, double whole) { return whole != 0 ? part / whole : 0; };
  const Vector ab = minus(b, a);
  const Vector ac = minus(c, a);
  const Vector ap = minus(place, a);
  const double d1 = dot(ab, ap);
  const double d2 = dot(ac, ap);
  if (d1 <= 0 && d2 <= 0)
  {
    return a;
  }
  const Vector bp = minus(ap, ab);
  const double d3 = dot(ab, bp);
  const double d4 = dot(ac, bp);
  if (d3 >= 0 && d4 <= d3)
  {
    return plus(a, ab);
  }
  const double vc = d1 * d4 - d3 * d2;
  if (vc <= 0 && d1 >= 0 && d3 <= 0 && d1 > d3)
  {
    return plus(a, scaled(ab, d1 / (d1 - d3)));
  }
  const Vector cp = minus(ap, ac);
  const double d5 = dot(ab, cp);
  const double d6 = dot(ac, cp);
  if (d6 >= 0 && d5 <= d6)
  {
    return plus(a, ac);
  }
  const double vb = d5 * d2 - d1 * d6;
  if (vb <= 0 && d2 >= 0 && d6 <= 0 && d2 > d6)
  {
    return plus(a, scaled(ac, d2 / (d2 - d6)));
  }
  const double va = d3 * d6 - d5 * d4;
  if (va <= 0 && d4 >= d3 && d5 >= d6)
  {
    const double along = share(d4 - d3, (d4 - d3) + (d5 - d6));
    return plus(plus(a, ab), scaled(minus(ac, ab), along));
  }
  const double whole = va + vb + vc;
  return plus(a, plus(scaled(ab, share(vb, whole)), scaled(ac, share(vc, whole))));
}

inline Vector nearestPlace(const Corners& triangle, const Vector& place)
{
  return nearestPlace(toVector(triangle[0]), toVector(triangle[1]), toVector(triangle[2]), place);
}

}
