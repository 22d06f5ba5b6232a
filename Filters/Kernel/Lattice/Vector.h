// SPDX-License-Identifier: BSD-3-Clause
// Vectors in double precision, and angles: for measures, never for exact decisions.
#pragma once

#include "Lattice/Lattice.h"

#include <cmath>

namespace cartesian
{

using Vector = std::array<double, 3>;

constexpr double Pi = 3.14159265358979323846;

constexpr double radians(double degrees)
{
  return degrees * Pi / 180;
}

inline Vector toVector(const Point& p)
{
  return { double(p[0]), double(p[1]), double(p[2]) };
}

// The odd level between the two even ones around it.
inline Level oddLevel(double level)
{
  return static_cast<Level>(2 * std::floor(level / 2) + 1);
}

inline Vector minus(const Point& p, const Point& q)
{
  return { double(p[0]) - q[0], double(p[1]) - q[1], double(p[2]) - q[2] };
}

inline Vector minus(const Vector& u, const Vector& v)
{
  return { u[0] - v[0], u[1] - v[1], u[2] - v[2] };
}

inline Vector plus(const Vector& u, const Vector& v)
{
  return { u[0] + v[0], u[1] + v[1], u[2] + v[2] };
}

inline Vector scaled(const Vector& u, double factor)
{
  return { u[0] * factor, u[1] * factor, u[2] * factor };
}

inline Vector cross(const Vector& u, const Vector& v)
{
  return { u[1] * v[2] - u[2] * v[1], u[2] * v[0] - u[0] * v[2], u[0] * v[1] - u[1] * v[0] };
}

inline double dot(const Vector& u, const Vector& v)
{
  return u[0] * v[0] + u[1] * v[1] + u[2] * v[2];
}

// To whole levels.
inline Vector rounded(const Vector& v)
{
  return { std::round(v[0]), std::round(v[1]), std::round(v[2]) };
}

inline double norm(const Vector& u)
{
  return std::sqrt(dot(u, u));
}

// Scaled to length 1; zero stays zero.
inline Vector unit(const Vector& u)
{
  const double length = norm(u);
  return length > 0 ? scaled(u, 1 / length) : u;
}

}
