#include "Lattice/Lattice.h"

#include <gtest/gtest.h>

#include <cmath>

using namespace cartesian;

namespace
{

Bounds domain()
{
  Bounds bounds = Bounds::none();
  for (int axis = 0; axis < 3; ++axis)
  {
    bounds.include(axis, -1.25);
    bounds.include(axis, 300.5);
  }
  return bounds;
}

}

TEST(Lattice, VerticesAreOddAndPlanesEven)
{
  const Lattice lattice(domain());
  for (int i = 0; i < 1000; ++i)
  {
    const double x = -1.25 + 301.75 * i / 999;
    EXPECT_FALSE(onPlane(lattice.vertex(0, x)));
    EXPECT_TRUE(onPlane(lattice.plane(0, x)));
    EXPECT_LE(std::abs(lattice.position(0, lattice.vertex(0, x)) - x), lattice.step());
    EXPECT_LE(std::abs(lattice.position(0, lattice.plane(0, x)) - x), lattice.step());
  }
}

TEST(Lattice, SinglePrecisionComesBackExactly)
{
  const Lattice lattice(domain());
  for (int i = 0; i < 1000; ++i)
  {
    const double x = 2.0F + 0.29F * static_cast<float>(i);
    EXPECT_EQ(lattice.position(2, lattice.vertex(2, x)), x);
  }
}

TEST(Lattice, LevelUndoesPosition)
{
  const Lattice lattice(domain());
  for (const Level level : { 0U, 1U, 2U, 12345678U, 4000000000U })
  {
    EXPECT_EQ(lattice.level(1, lattice.position(1, level)), level);
  }
}
