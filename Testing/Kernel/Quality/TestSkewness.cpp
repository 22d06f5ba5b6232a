// SPDX-License-Identifier: BSD-3-Clause
// Skewness against what can be worked out by hand.
#include "Quality/Skewness.h"

#include <gtest/gtest.h>

using namespace cartesian;

namespace
{

// Of area `unit` squared, around the origin, across z.
struct Square
{
  explicit Square(double unit = 1)
  {
    for (Vector& node : nodes)
    {
      node = scaled(node, unit);
    }
  }

  std::array<Vector, 4> nodes{ { { -0.5, -0.5, 0 }, { 0.5, -0.5, 0 }, { 0.5, 0.5, 0 },
    { -0.5, 0.5, 0 } } };
  std::array<std::uint32_t, 4> corners{ 0, 1, 2, 3 };

  Ring ring() const { return { nodes.data(), corners.data(), 4 }; }
};

// Of the square between two cubes with edges of `unit`, the upper one of which is shifted, in these units.
bool isSkewedBetween(double shiftX, double shiftY, double limit, double unit = 1)
{
  const Vector aside{ -shiftX / 2 * unit, -shiftY / 2 * unit,
    0 }; // from half-way to the upper centre
  const double distance = norm(Vector{ shiftX, shiftY, 1 }) * unit;
  return isSkewed(Square(unit).ring(), { 0, 0, 0 }, aside, ShareOfDistance * distance, limit);
}

void expectSkewness(double shiftX, double shiftY, double value)
{
  for (const double unit : { 1.0, 1e-9, 1e6 })
  {
    EXPECT_TRUE(isSkewedBetween(shiftX, shiftY, value * 0.999999, unit)) << shiftX << " " << shiftY;
    EXPECT_FALSE(isSkewedBetween(shiftX, shiftY, value * 1.000001, unit))
      << shiftX << " " << shiftY;
  }
}

}

TEST(Skewness, OfASquareBetweenCubesIsTheShift)
{
  EXPECT_FALSE(isSkewedBetween(0, 0, 0));
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
