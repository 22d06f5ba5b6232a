// SPDX-License-Identifier: BSD-3-Clause
// Where the surface meets cutting planes and lines, exactly (sections 4.2, 7.1).
//
// All inputs are lattice points with odd levels (vertices) and even levels (planes). A crossing
// is even on its planes; in a free direction its exact rational coordinate is rounded to the odd
// level between the two even ones that enclose it. So rounding never carries a point across a
// plane, and every later decision (which side of a plane is this point on?) is a comparison of
// two integers that can't be wrong.
//
// Ties do not exist (simulation of simplicity): read the whole set of cutting planes as shifted
// by (e, e^2, e^3), e infinitesimally small. A crossing that would fall exactly on an even level
// goes to the side where the shifted planes leave it. The result depends on the exact geometry
// only, never on the order in which vertices are given.
#pragma once

#include "Lattice/Lattice.h"

namespace cartesian
{

using Corners = std::array<Point, 3>; // of a triangle

// Twice the area of a triangle, projected along x, y and z; of the sign of its normal.
std::array<Wide, 3> exactNormal(const Corners& triangle);

// The point of segment ab on the plane `axis` = `plane`; the ends lie on different sides of it.
Point crossPlane(const Point& a, const Point& b, int axis, Level plane);

// The point of a triangle on the line along axis `along` through `at`, whose other two levels
// are planes. The line passes through the triangle (shifted as above), which is not parallel to it.
Point crossLine(const Corners& triangle, int along, const Point& at);

}
