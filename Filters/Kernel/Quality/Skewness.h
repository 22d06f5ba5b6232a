// SPDX-License-Identifier: BSD-3-Clause
// OpenFOAM's skewness of a face: how far its centre is from where the line between the centres of its cells meets its
// plane (at the boundary: from the foot of the cell's centre), by how far the face reaches in that direction. Any unit
// of length.
#pragma once

#include "Polyhedra/CellGeometry.h"

namespace cartesian
{

// Skewness is measured over at least these parts of the distance between the centres, and of the height above a
// boundary face.
constexpr double ShareOfDistance = 0.2;
constexpr double ShareOfHeight = 0.4;

// How far the corners reach from the centre along `aside`, times the length of `aside`; at least `least`.
template <class Corner>
double reachAlong(
  std::size_t size, Corner&& corner, const Vector& centre, const Vector& aside, double least)
{
  double reach = least;
  for (std::size_t i = 0; i < size; ++i)
  {
    reach = std::max(reach, std::abs(dot(minus(corner(i), centre), aside)));
  }
  return reach;
}

// Whether it is larger than `limit`; `aside`: from where the line meets the plane to the centre; `least`: the reach, without
// the length of `aside`. Looks at the corners only where it has to.
inline bool isSkewed(
  const Ring& ring, const Vector& centre, const Vector& aside, double least, double limit)
{
  const double miss = norm(aside);
  return !(miss <= limit * least) &&
    miss * miss > limit *
      reachAlong(
        ring.size, [&](std::size_t i) { return ring[i]; }, centre, aside, 0);
}

}
