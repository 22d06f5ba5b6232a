// SPDX-License-Identifier: BSD-3-Clause
// OpenFOAM's skewness of a face: how far its centre is from where the line between the centres meets its plane, by how far
// the face reaches in that direction.
#pragma once

#include "Lattice/Vector.h"

#include <algorithm>
#include <cmath>

namespace cartesian
{

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

}
