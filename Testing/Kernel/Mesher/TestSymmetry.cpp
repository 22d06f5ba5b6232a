// The mesh does not care where the surface lies or which axis is which.
#include "Support/Effort.h"
#include "Support/MeshChecker.h"

#include <gtest/gtest.h>

#include <cmath>

using namespace cartesian;

namespace
{

// Coordinates in 1/1024: they stay exact when moved.
Soup onGrid(const Soup& soup)
{
  return soup.each([](const Vector& p) {
    return Vector{ std::round(1024 * p[0]) / 1024, std::round(1024 * p[1]) / 1024,
      std::round(1024 * p[2]) / 1024 };
  });
}

// A surface and meshlines that nothing coincides with.
Soup generic(unsigned seed)
{
  return bumpySphere(seed, 5).turned();
}

GridSpec genericGrid()
{
  GridSpec grid;
  grid.meshlines = { { { -2, -0.71, -0.23, 0.119, 0.57, 2 }, { -2, -0.39, 0.413, 2 },
    { -2, -0.877, -0.3, 0.211, 0.6, 0.83, 2 } } };
  return grid;
}

GridSpec permuted(const GridSpec& grid, const std::array<int, 3>& axes)
{
  GridSpec result = grid;
  for (int axis = 0; axis < 3; ++axis)
  {
    result.meshlines[axis] = grid.meshlines[axes[axis]];
  }
  return result;
}

}

TEST(Symmetry, TranslationMovesThePointsAndNothingElse)
{
  for (const Soup& still : { onGrid(bumpySphere(1, 6)), octahedron(1), cube(), onGrid(comb(5)) })
  {
    for (const int levels : { 0, 1 })
    {
      const TestOptions options = asTheyAre(0, depth(levels));
      const Vector by = { 0.5, -1.25, 3 };
      const MeshArrays before = meshOf(still, cellsOf(0.125), options).mesh;
      MeshArrays after = meshOf(still.moved(by), cellsOf(0.125), options).mesh;
      for (std::size_t i = 0; i < after.points.size(); ++i)
      {
        after.points[i] -= by[i % 3];
      }
      for (int axis = 0; axis < 3; ++axis)
      {
        for (double& x : after.meshlines[axis])
        {
          x -= by[axis];
        }
      }
      EXPECT_TRUE(before == after);
    }
  }
}

TEST(Symmetry, AxesMayBePermuted)
{
  for (unsigned seed = 1; seed <= repeats(3); ++seed)
  {
    const MeshArrays mesh = meshOf(generic(seed), genericGrid()).mesh;
    for (const std::array<int, 3>& axes : std::vector<std::array<int, 3>>{
           { 1, 2, 0 }, { 2, 0, 1 }, { 1, 0, 2 }, { 0, 2, 1 }, { 2, 1, 0 } })
    {
      const MeshArrays other =
        meshOf(generic(seed).permuted(axes), permuted(genericGrid(), axes)).mesh;
      EXPECT_TRUE(isValid(other));
      ASSERT_EQ(mesh.cells(), other.cells());
      EXPECT_EQ(mesh.points.size(), other.points.size());
      EXPECT_EQ(mesh.boundaryCell.size(), other.boundaryCell.size());
      const auto volumes = volumesByBox(mesh);
      for (const auto& [box, expected] : volumesByBox(other))
      {
        std::array<int, 3> original{};
        for (int axis = 0; axis < 3; ++axis)
        {
          original[axes[axis]] = box[axis];
        }
        const auto found = volumes.find(original);
        ASSERT_TRUE(found != volumes.end());
        ASSERT_EQ(found->second.size(), expected.size());
        for (std::size_t i = 0; i < expected.size(); ++i)
        {
          EXPECT_NEAR(found->second[i], expected[i], 1e-9);
        }
      }
    }
  }
}
