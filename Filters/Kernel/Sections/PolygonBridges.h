// SPDX-License-Identifier: BSD-3-Clause
// Polygons with holes as polygons without: each hole is joined to the ring around it by a bridge, two edges that coincide.
#pragma once

#include "Lattice/Vector.h"

#include <cstddef>
#include <utility>
#include <vector>

namespace cartesian
{

using Bridged = std::vector<std::pair<std::size_t, std::size_t>>; // a ring and its corner, in order

// `rings`: in a plane with that normal, counter-clockwise seen from above; holes clockwise. They do not cross. A polygon for
// each ring that is no hole.
std::vector<Bridged> bridgeHoles(
  const std::vector<std::vector<Vector>>& rings, const Vector& normal);

}
