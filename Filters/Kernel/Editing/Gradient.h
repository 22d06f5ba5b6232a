// SPDX-License-Identifier: BSD-3-Clause
// A number with its derivatives by the three coordinates of one point: a formula that is written for any kind of number
// gives its value with doubles, and with these its gradient too (forward differentiation).
#pragma once

#include "Polyhedra/CellGeometry.h"

namespace cartesian
{

struct WithGradient
{
  double value = 0;
  Vector slope{};

  WithGradient() = default;
  WithGradient(double constant) // NOLINT(google-explicit-constructor): constants are numbers too
    : value(constant)
  {
  }
  WithGradient(double v, const Vector& s)
    : value(v)
    , slope(s)
  {
  }

  // A coordinate of the point itself.
  static WithGradient variable(double value, std::size_t axis)
  {
    WithGradient x(value);
    x.slope[axis] = 1;
    return x;
  }
};

inline double valueOf(const WithGradient& x)
{
  return x.value;
}

inline WithGradient operator-(const WithGradient& x)
{
  return { -x.value, scaled(x.slope, -1) };
}
inline WithGradient operator+(const WithGradient& x, const WithGradient& y)
{
  return { x.value + y.value, plus(x.slope, y.slope) };
}
inline WithGradient operator-(const WithGradient& x, const WithGradient& y)
{
  return { x.value - y.value, minus(x.slope, y.slope) };
}
inline WithGradient operator*(const WithGradient& x, const WithGradient& y)
{
  return { x.value * y.value, plus(scaled(x.slope, y.value), scaled(y.slope, x.value)) };
}
inline WithGradient operator/(const WithGradient& x, const WithGradient& y)
{
  const double quotient = x.value / y.value;
  return { quotient, scaled(minus(x.slope, scaled(y.slope, quotient)), 1 / y.value) };
}
inline WithGradient& operator+=(WithGradient& x, const WithGradient& y)
{
  return x = x + y;
}
inline bool operator<(const WithGradient& x, const WithGradient& y)
{
  return x.value < y.value;
}
inline bool operator>(const WithGradient& x, const WithGradient& y)
{
  return x.value > y.value;
}
inline WithGradient sqrt(const WithGradient& x)
{
  const double root = std::sqrt(x.value);
  return { root, root > 0 ? scaled(x.slope, 0.5 / root) : Vector{} };
}
inline WithGradient log1p(const WithGradient& x)
{
  return { std::log1p(x.value), scaled(x.slope, 1 / (1 + x.value)) };
}
inline WithGradient abs(const WithGradient& x)
{
  return x.value < 0 ? -x : x;
}

using GradientVector = VectorOf<WithGradient>;

inline Vector valuesOf(const GradientVector& v)
{
  return { v[0].value, v[1].value, v[2].value };
}

inline GradientVector minus(const GradientVector& u, const GradientVector& v)
{
  return { u[0] - v[0], u[1] - v[1], u[2] - v[2] };
}
inline GradientVector plus(const GradientVector& u, const GradientVector& v)
{
  return { u[0] + v[0], u[1] + v[1], u[2] + v[2] };
}
inline GradientVector scaled(const GradientVector& u, const WithGradient& factor)
{
  return { u[0] * factor, u[1] * factor, u[2] * factor };
}
inline GradientVector cross(const GradientVector& u, const GradientVector& v)
{
  return { u[1] * v[2] - u[2] * v[1], u[2] * v[0] - u[0] * v[2], u[0] * v[1] - u[1] * v[0] };
}
inline WithGradient dot(const GradientVector& u, const GradientVector& v)
{
  return u[0] * v[0] + u[1] * v[1] + u[2] * v[2];
}
inline WithGradient norm(const GradientVector& u)
{
  return sqrt(dot(u, u));
}

}
