// SPDX-License-Identifier: BSD-3-Clause
// The surface in smaller triangles, so that it can be moved by different amounts in different places.
#pragma once

#include "Surface/Surface.h"

namespace cartesian
{

// Divides edges longer than `longest` (levels, at least 16) in the middle until there are none, or more than
// MostDividedTriangles. Triangles with a common edge divide it alike; new vertices are at most a level from it. Parts
// take their triangle's place, boundary and number.
constexpr std::size_t MostDividedTriangles = 4'000'000;
void divideTriangles(Surface& surface, double longest);

}
