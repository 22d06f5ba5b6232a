// SPDX-License-Identifier: BSD-3-Clause
// Skewness against what can be worked out by hand.
#include "Quality/FaceMeasures.h"

#include <gtest/gtest.h>

using namespace cartesian;

namespace
{

// Of the square between two cubes with edges of `unit`, the upper one of which is shifted, in these units.
double skewnessBetween(double shiftX, double shiftY, double unit = 1)
{
  const std::array<Vector, 4> square{ { { -0.5, -0.5, 0 }, { 0.5, -0.5, 0 }, { 0.5, 0.5, 0 },
    { -0.5, 0.5, 0 } } };
  const Vector aside{ -shiftX / 2 * unit, -shiftY / 2 * unit,
    0 }; // from half-way to the upper centre
  const double distance = norm(Vector{ shiftX, shiftY, 1 }) * unit;
  return skewness(
    4, [&](std::size_t i) { return scaled(square[i], unit); }, Vector{}, aside,
    ShareOfDistance * distance);
}

void expectSkewness(double shiftX, double shiftY, double value)
{
  for (const double unit : { 1.0, 1e-9, 1e6 })
  {
    EXPECT_NEAR(skewnessBetween(shiftX, shiftY, unit), value, 1e-12) << shiftX << " " << shiftY;
  }
}

}

TEST(Skewness, OfASquareBetweenCubesIsTheShift)
{
  EXPECT_EQ(skewnessBetween(0, 0), 0);
  for (const double shift : { 0.1, 0.5, 1.0, 2.0 })
  {
    expectSkewness(shift, 0, shift); // half of it, over half an edge
    expectSkewness(0, -shift, shift);
    expectSkewness(shift / 2, shift / 2, shift / 2); // over half a diagonal
  }
}

TEST(Skewness, IsMeasuredOverAPartOfTheDistanceAtLeast)
{
  expectSkewness(3, 0, 1.5 / (0.2 * std::sqrt(10)));
}
