// SPDX-License-Identifier: BSD-3-Clause
// Points in one cutting plane, as seen from the side that its normal points to.
#pragma once

#include "Base/Rings.h"
#include "Lattice/Lattice.h"

namespace cartesian
{

// Levels along the two free axes, axis + 1 and axis + 2, which are right-handed with the normal.
struct PlanePoint
{
  std::int64_t a;
  std::int64_t b;
};

inline PlanePoint flatten(const Point& p, int axis)
{
  return { static_cast<std::int64_t>(following(p, axis)),
    static_cast<std::int64_t>(preceding(p, axis)) };
}

// Twice the area of the triangle pqr, positive if counter-clockwise; exact.
inline Wide turn(const PlanePoint& p, const PlanePoint& q, const PlanePoint& r)
{
  return static_cast<Wide>(q.a - p.a) * (r.b - p.b) - static_cast<Wide>(q.b - p.b) * (r.a - p.a);
}

inline int sign(Wide x)
{
  return (x > 0) - (x < 0);
}

}
