// SPDX-License-Identifier: BSD-3-Clause
#include "Lattice/Crossing.h"

#include <cmath>

namespace cartesian
{

namespace
{

std::int64_t difference(Level a, Level b)
{
  return static_cast<std::int64_t>(a) - static_cast<std::int64_t>(b);
}

// Rounding error of a crossing computed in double precision, in levels: four operations on numbers
// below 2^33.
constexpr double RoundingOfLevels = 1e-5;

// The odd level around x, or 0 if x may be within `error` of an even level.
Level oddLevelIfSure(double x, double error)
{
  constexpr double BeyondLevels = 4294967296.0;
  if (!(x >= 0 && x < BeyondLevels))
  {
    return 0;
  }
  const double half = x * 0.5;
  const auto below = static_cast<std::int64_t>(half);
  const double fraction = (half - static_cast<double>(below)) * 2;
  return fraction > error && fraction < 2 - error ? static_cast<Level>(2 * below) + 1 : 0;
}

// The odd level around base + numerator / denominator; exactly on an even level, `tieUp` decides.
template <class Integer>
Level oddLevel(Level base, Integer numerator, Integer denominator, bool tieUp)
{
  if (denominator < 0)
  {
    numerator = -numerator;
    denominator = -denominator;
  }
  // No line or plane is parallel to what it crosses (Crossing.h).
  Integer quotient = numerator / denominator; // NOLINT(clang-analyzer-core.DivideZero)
  Integer remainder = numerator % denominator;
  if (remainder < 0)
  {
    --quotient;
    remainder += denominator;
  }
  const Integer whole = quotient + static_cast<Integer>(base);
  if ((whole & 1) != 0)
  {
    return static_cast<Level>(whole);
  }
  return static_cast<Level>(remainder > 0 || tieUp ? whole + 1 : whole - 1);
}

// Whether a crossing exactly on an even level lies above that level once the planes are shifted.
bool lineTieUp(const std::array<Wide, 3>& normal, int along)
{
  for (int axis = 0; axis < 3; ++axis)
  {
    const Wide n = normal[axis];
    if (axis == along)
    {
      return false; // the plane across `along` moves up furthest
    }
    if (n != 0)
    {
      return (n > 0) != (normal[along] > 0);
    }
  }
  return false;
}

}

std::array<Wide, 3> exactNormal(const Corners& t)
{
  std::array<Wide, 3> u;
  std::array<Wide, 3> v;
  for (int axis = 0; axis < 3; ++axis)
  {
    u[axis] = difference(t[1][axis], t[0][axis]);
    v[axis] = difference(t[2][axis], t[0][axis]);
  }
  std::array<Wide, 3> normal;
  for (int axis = 0; axis < 3; ++axis)
  {
    const int b = (axis + 1) % 3;
    const int c = (axis + 2) % 3;
    normal[axis] = u[b] * v[c] - u[c] * v[b];
  }
  return normal;
}

Level crossPlane(const Point& a, const Point& b, int axis, Level plane, int free)
{
  const std::int64_t rise = difference(b[free], a[free]);
  const std::int64_t run = difference(b[axis], a[axis]);
  const std::int64_t part = difference(plane, a[axis]);
  const double x =
    a[free] + static_cast<double>(rise) * static_cast<double>(part) / static_cast<double>(run);
  if (const Level sure = oddLevelIfSure(x, RoundingOfLevels))
  {
    return sure;
  }
  // The crossing moves by slope * shift(axis), the planes of `free` by shift(free). The shift of
  // the lower axis is infinitely larger.
  const bool tieUp = axis < free && (rise > 0) == (run > 0);
  return oddLevel<Wide>(a[free], static_cast<Wide>(rise) * part, run, tieUp);
}

Point crossPlane(const Point& a, const Point& b, int axis, Level plane)
{
  const int u = (axis + 1) % 3;
  const int v = (axis + 2) % 3;
  Point p;
  p[axis] = plane;
  p[u] = crossPlane(a, b, axis, plane, u);
  p[v] = crossPlane(a, b, axis, plane, v);
  return p;
}

Point crossLine(const Corners& t, int along, const Point& at)
{
  const int b = (along + 1) % 3;
  const int c = (along + 2) % 3;
  const std::array<Wide, 3> normal = exactNormal(t);
  const std::int64_t db = difference(at[b], t[0][b]);
  const std::int64_t dc = difference(at[c], t[0][c]);
  const double pb = static_cast<double>(normal[b]) * static_cast<double>(db);
  const double pc = static_cast<double>(normal[c]) * static_cast<double>(dc);
  const auto na = static_cast<double>(normal[along]);
  const double x = t[0][along] - (pb + pc) / na;
  const double error =
    RoundingOfLevels + std::ldexp((std::abs(pb) + std::abs(pc)) / std::abs(na), -50);
  Point p = at;
  p[along] = oddLevelIfSure(x, error);
  if (p[along] == 0)
  {
    const Wide numerator = -(normal[b] * db + normal[c] * dc);
    p[along] = oddLevel<Wide>(t[0][along], numerator, normal[along], lineTieUp(normal, along));
  }
  return p;
}

}
