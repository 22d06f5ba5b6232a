// SPDX-License-Identifier: BSD-3-Clause
#include "Lattice/Lattice.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace cartesian
{

namespace
{

// Levels kept free below the domain, so that there is room for planes around it. Odd.
constexpr double Margin = 9;

// origin + step * level stays exact in double precision.
constexpr int BitsOfADouble = 52;

double powerOfTwoAtLeast(double x)
{
  int exponent = 0;
  const double fraction = std::frexp(x, &exponent);
  return std::ldexp(1.0, fraction == 0.5 ? exponent - 1 : exponent);
}

}

Bounds Bounds::none()
{
  constexpr double inf = std::numeric_limits<double>::infinity();
  return { { inf, inf, inf }, { -inf, -inf, -inf } };
}

void Bounds::include(int axis, double x)
{
  low[axis] = std::min(low[axis], x);
  high[axis] = std::max(high[axis], x);
}

double Bounds::longest() const
{
  return std::max({ high[0] - low[0], high[1] - low[1], high[2] - low[2] });
}

Lattice::Lattice(const Bounds& domain)
{
  double farthest = 0;
  for (int axis = 0; axis < 3; ++axis)
  {
    farthest = std::max({ farthest, std::abs(domain.low[axis]), std::abs(domain.high[axis]) });
  }
  const double finest = std::max(
    domain.longest() / (LevelsOfTheDomain - 4 * Margin), std::ldexp(farthest, -BitsOfADouble));
  step_ = powerOfTwoAtLeast(std::max(finest, std::numeric_limits<double>::min()));
  for (int axis = 0; axis < 3; ++axis)
  {
    origin_[axis] = step_ * (2 * std::floor(domain.low[axis] / (2 * step_)) - Margin);
  }
}

Lattice::Lattice(const std::array<double, 3>& origin, double step)
  : origin_(origin)
  , step_(step)
{
}

Level Lattice::vertex(int axis, double x) const
{
  return static_cast<Level>(2 * std::floor((x - origin_[axis]) / (2 * step_)) + 1);
}

Level Lattice::plane(int axis, double x) const
{
  return static_cast<Level>(2 * std::floor((x - origin_[axis]) / (2 * step_) + 0.5));
}

Level Lattice::level(int axis, double x) const
{
  return static_cast<Level>(std::llround((x - origin_[axis]) / step_));
}

}
