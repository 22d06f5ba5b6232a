// SPDX-License-Identifier: BSD-3-Clause
// Exact crossings of the surface with cutting planes and lines (sections 4.2, 7.1).
//
// All inputs are lattice points: vertices have odd levels, planes even ones. A crossing has even
// levels on its planes; in a free direction, its exact rational coordinate is rounded to the odd
// level between the two even ones that enclose it. So rounding never moves a point across a plane,
// and every later decision (on which side of a plane is this point?) is a comparison of two
// integers, which cannot go wrong.
//
// There are no ties (simulation of simplicity): all cutting planes are regarded as shifted by (e,
// e^2, e^3) with an infinitesimally small e. A crossing exactly on an even level goes to the side
// on which the shift leaves it. The result depends on the exact geometry only, never on the order
// of the vertices.
#pragma once

#include "Lattice/Lattice.h"

namespace cartesian
{

using Corners = std::array<Point, 3>; // of a triangle

// Twice the signed areas of a triangle projected along x, y and z: its normal.
std::array<Wide, 3> exactNormal(const Corners& triangle);

// The point of segment ab on the plane `axis` = `plane`, which separates a from b.
Point crossPlane(const Point& a, const Point& b, int axis, Level plane);

// Its level along one of the two other axes.
Level crossPlane(const Point& a, const Point& b, int axis, Level plane, int free);

// The point of a triangle on the line along axis `along` through `at`, whose other two levels are
// planes. The line (shifted as above) must pass through the triangle and not be parallel to it.
Point crossLine(const Corners& triangle, int along, const Point& at);

}
