// Cutting planes from cell sizes and meshlines.
#include "Lattice/Meshlines.h"

#include "Base/Error.h"
#include "Lattice/Lattice.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>

using namespace cartesian;

namespace
{

Bounds bounds(double low, double high)
{
  Bounds b = Bounds::none();
  for (int axis = 0; axis < 3; ++axis)
  {
    b.include(axis, low);
    b.include(axis, high);
  }
  return b;
}

Meshlines planesOf(const GridSpec& grid, const Bounds& surface)
{
  return onLattice(grid, surface, Lattice(domainOf(grid, surface)));
}

GridSpec cells(double size)
{
  GridSpec grid;
  grid.cellSize = size;
  return grid;
}

}

TEST(Meshlines, AreEvenAndIncrease)
{
  for (const double size : { 1e-3, 0.1, 1 / 3.0, 0.7, 1.0, 900.0 })
  {
    for (const auto& levels : planesOf(cells(size), bounds(-0.3, 0.7)))
    {
      ASSERT_GE(levels.size(), 2U);
      EXPECT_TRUE(std::all_of(levels.begin(), levels.end(), onPlane));
      EXPECT_TRUE(
        std::is_sorted(levels.begin(), levels.end(), std::less_equal<>()) || levels.size() == 2);
      EXPECT_TRUE(std::adjacent_find(levels.begin(), levels.end()) == levels.end());
    }
  }
}

// Neither 0.3 / 0.1 nor 1 / (1 / 49.0) is a whole number in double precision.
TEST(Meshlines, CellSizesThatDivideTheSurfaceMakeNoSliver)
{
  EXPECT_EQ(planesOf(cells(0.1), bounds(0, 0.3))[0].size(), 4U);
  for (int n = 1; n < 200; ++n)
  {
    EXPECT_EQ(planesOf(cells(1.0 / n), bounds(0, 1))[1].size(), n + 1U);
    EXPECT_EQ(planesOf(cells(1e-6 / n), bounds(1, 1 + 1e-6))[1].size(), n + 1U);
  }
}

TEST(Meshlines, DefaultIsTheLongestDimensionOverFifty)
{
  Bounds surface = bounds(0, 10);
  surface.include(2, 100);
  const Meshlines planes = planesOf({}, surface);
  EXPECT_EQ(planes[0].size(), 6U);
  EXPECT_EQ(planes[2].size(), 51U);
}

TEST(Meshlines, UniformCellsHoldTheSurface)
{
  for (const double size : { 0.01, 0.1, 0.25, 0.3, 5.0 })
  {
    const Bounds surface = bounds(-1, 1);
    const Lattice lattice(domainOf(cells(size), surface));
    const Meshlines planes = onLattice(cells(size), surface, lattice);
    for (int axis = 0; axis < 3; ++axis)
    {
      EXPECT_LT(planes[axis].front(), lattice.vertex(axis, -1));
      EXPECT_GT(planes[axis].back(), lattice.vertex(axis, 1));
      for (std::size_t i = 0; i < planes[axis].size(); ++i)
      {
        const double x = -1 + static_cast<double>(i) * size;
        EXPECT_LE(std::abs(lattice.position(axis, planes[axis][i]) - x), 4 * lattice.step());
      }
    }
  }
}

// The first and the last meshline are moved outward if they coincide with walls of the surface.
TEST(Meshlines, StepAsideFromWalls)
{
  GridSpec grid;
  grid.meshlines.fill({ 0, 0.25, 0.5, 1 });
  const Bounds surface = bounds(0, 1);
  const Lattice lattice(domainOf(grid, surface));
  const Meshlines planes = onLattice(grid, surface, lattice);
  for (int axis = 0; axis < 3; ++axis)
  {
    EXPECT_EQ(planes[axis].size(), 4U);
    EXPECT_LT(planes[axis].front(), lattice.vertex(axis, 0));
    EXPECT_GT(planes[axis].back(), lattice.vertex(axis, 1));
  }
}

TEST(Meshlines, WinOverCellSize)
{
  GridSpec grid = cells(0.1);
  grid.meshlines[1] = { -5, 0.3, 9 };
  const Meshlines planes = planesOf(grid, bounds(0, 1));
  EXPECT_EQ(planes[0].size(), 11U);
  EXPECT_EQ(planes[1].size(), 3U);
  EXPECT_EQ(planes[2].size(), 11U);
}

TEST(Meshlines, GridsThatDoNotFitAreRefusedBeforeTheyAreBuilt)
{
  EXPECT_NO_THROW(checkGrid(cells(0.01), bounds(0, 1), 1e9));
  try
  {
    checkGrid(cells(1e-6), bounds(0, 1), 1e9);
    FAIL() << "no error";
  }
  catch (const Error& error)
  {
    EXPECT_EQ(error.fault, Fault::TooManyBoxes);
    EXPECT_NE(std::string(error.what()).find("1e+06 x 1e+06 x 1e+06 boxes"), std::string::npos);
  }
}

TEST(Meshlines, IntervalOfALevel)
{
  const std::vector<Level> lines = { 2, 6, 10 };
  EXPECT_EQ(intervalOf(lines, 1), -1);
  EXPECT_EQ(intervalOf(lines, 3), 0);
  EXPECT_EQ(intervalOf(lines, 6), 1);
  EXPECT_EQ(intervalOf(lines, 9), 1);
  EXPECT_EQ(intervalOf(lines, 10), 2);
  EXPECT_EQ(intervalOf(lines, 4000000001U), 2);
}

TEST(Meshlines, IntervalsOfEvenAndUnevenLines)
{
  std::mt19937 random(7);
  for (std::size_t n = 0; n < 40; ++n)
  {
    const bool even = n % 2 == 0;
    std::vector<Level> lines;
    for (Level level = 4; lines.size() < n;
         level += even ? 1000 : 2 + 2 * Level(random() % (n * n)))
    {
      lines.push_back(level);
    }
    const Level end = lines.empty() ? 100 : lines.back() + 20;
    for (int i = 0; i < 300; ++i)
    {
      const Level level = i < 20 && !lines.empty() ? lines[random() % n] : Level(random() % end);
      const auto below =
        std::count_if(lines.begin(), lines.end(), [&](Level line) { return line <= level; });
      ASSERT_EQ(intervalOf(lines, level), below - 1);
    }
  }
}
