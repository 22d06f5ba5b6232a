// Skewness against what can be worked out by hand.
#include "Acceptance/Skewness.h"

#include <gtest/gtest.h>

#include <random>

using namespace cartesian;

namespace
{

constexpr double Close = 1e-12;

// Of area 1, around the origin, across z.
struct Square
{
  std::array<Vector, 4> nodes{ { { -0.5, -0.5, 0 }, { 0.5, -0.5, 0 }, { 0.5, 0.5, 0 },
    { -0.5, 0.5, 0 } } };
  std::array<std::uint32_t, 4> corners{ 0, 1, 2, 3 };

  Ring ring() const { return { nodes.data(), corners.data(), 4 }; }
};

// Of the square between two unit cubes, the upper one of which is shifted.
FaceSkewness between(double shiftX, double shiftY)
{
  const Vector aside{ -shiftX / 2, -shiftY / 2, 0 }; // from half-way to the upper centre
  const double distance = norm(Vector{ shiftX, shiftY, 1 });
  return skewnessOf(Square().ring(), { 0, 0, 0 }, aside, ShareOfDistance * distance);
}

}

TEST(Skewness, OfASquareBetweenCubesIsTheShift)
{
  EXPECT_EQ(between(0, 0).value(), 0);
  for (const double shift : { 0.1, 0.5, 1.0, 2.0 })
  {
    EXPECT_NEAR(between(shift, 0).value(), shift, Close); // half of it, over half an edge
    EXPECT_NEAR(between(0, -shift).value(), shift, Close);
    EXPECT_NEAR(between(shift / 2, shift / 2).value(), shift / 2, Close); // over half a diagonal
    EXPECT_NEAR(between(shift, 0).reachAlone(), 0.5, Close);
  }
}

TEST(Skewness, IsMeasuredOverAPartOfTheDistanceAtLeast)
{
  EXPECT_NEAR(between(3, 0).value(), 1.5 / (0.2 * std::sqrt(10)), Close);
  EXPECT_NEAR(between(3, 0).reachAlone(), 0.2 * std::sqrt(10), Close);
}

TEST(Skewness, HasNoUnit)
{
  const Square square;
  std::array<Vector, 4> nodes = square.nodes;
  for (Vector& node : nodes)
  {
    node = scaled(node, 1e-9);
  }
  const double ofSmall =
    skewnessOf({ nodes.data(), square.corners.data(), 4 }, { 0, 0, 0 }, { 4e-10, 1e-10, 0 }, 1e-10)
      .value();
  EXPECT_NEAR(ofSmall, skewnessOf(square.ring(), { 0, 0, 0 }, { 0.4, 0.1, 0 }, 0.1).value(), Close);
}

TEST(Skewness, IsBeyondALimitWhereItsValueIs)
{
  std::mt19937 random(7);
  std::uniform_real_distribution<double> part(-1, 1);
  int beyond = 0;
  for (int i = 0; i < 1000; ++i)
  {
    const Vector aside{ part(random), part(random), 0 };
    const double least = std::abs(part(random));
    const double limit = 2 + part(random);
    const double value = skewnessOf(Square().ring(), { 0, 0, 0 }, aside, least).value();
    EXPECT_EQ(isSkewed(Square().ring(), { 0, 0, 0 }, aside, least, limit), value > limit);
    beyond += value > limit ? 1 : 0;
  }
  EXPECT_GT(beyond, 50);
  EXPECT_LT(beyond, 950);
}
