// SPDX-License-Identifier: BSD-3-Clause
// A point that sees all of a cell's faces from inside.
#pragma once

#include "Lattice/Vector.h"

#include <optional>
#include <vector>

namespace cartesian
{

struct HalfSpace
{
  Vector outward; // a unit vector
  double offset;  // of the points p in it, dot(outward, p) is at most this
};

// The point deepest inside all half spaces: the centre of the largest ball in them, at most `size` from `near` along each
// axis. None if no point is inside all of them.
std::optional<Vector> starPoint(
  const std::vector<HalfSpace>& spaces, const Vector& near, double size);

}
