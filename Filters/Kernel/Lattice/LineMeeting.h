// SPDX-License-Identifier: BSD-3-Clause
// Where a line meets a triangle, in double precision: for measures, never for exact decisions.
#pragma once

#include "Lattice/Crossing.h"
#include "Lattice/Vector.h"

namespace cartesian
{

// Of the line start + distance * direction and the triangle's plane; not a number or infinite where they are
// parallel. Within the triangle second and third are at least 0 and at most 1 together.
struct LineMeeting
{
  double distance;
  double second; // weights of these corners
  double third;
  bool leaves; // in the direction of the triangle's normal
};

inline LineMeeting meetLine(const Corners& c, const Vector& start, const Vector& direction)
{
  const Vector u = minus(c[1], c[0]);
  const Vector v = minus(c[2], c[0]);
  const Vector p = cross(direction, v);
  const double volume = dot(u, p);
  const Vector from = minus(start, toVector(c[0]));
  const Vector q = cross(from, u);
  return { dot(v, q) / volume, dot(from, p) / volume, dot(direction, q) / volume, volume < 0 };
}

}
