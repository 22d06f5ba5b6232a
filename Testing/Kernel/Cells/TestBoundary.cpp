// Which boundary faces belong to that removed cells expose (section 4.10).
#include "Support/Pipeline.h"

#include <gtest/gtest.h>

using namespace cartesian;

namespace
{

Vector middleOf(const MeshArrays& mesh, std::size_t face)
{
  Vector sum{};
  const auto first = static_cast<std::size_t>(mesh.boundaryStart[face]);
  const auto end = static_cast<std::size_t>(mesh.boundaryStart[face + 1]);
  for (std::size_t i = first; i < end; ++i)
  {
    const auto point = static_cast<std::size_t>(mesh.boundaryPoints[i]);
    sum =
      plus(sum, { mesh.points[3 * point], mesh.points[3 * point + 1], mesh.points[3 * point + 2] });
  }
  return scaled(sum, 1.0 / static_cast<double>(end - first));
}

}

// One half of a ball on either side of a plane amid boxes: its nearest boundary is that of its own side.
TEST(Boundary, OfExposedFacesIsTheNearest)
{
  Soup ball = sphere(8, 1);
  ball.boundary.clear();
  for (std::size_t t = 0; t < ball.triangles.size(); ++t)
  {
    const auto& corners = ball.triangles[t];
    double x = 0;
    for (const std::uint32_t corner : corners)
    {
      x += ball.points[corner][0];
    }
    ball.boundary.push_back(x > 0 ? 1 : 0);
  }
  GridSpec grid = cellsOf(0.2);
  grid.meshlines[0] = { -1.1, -0.9, -0.7, -0.5, -0.3, -0.1, 0.1, 0.3, 0.5, 0.7, 0.9, 1.1 };
  const Meshed meshed = meshOf(ball, grid, asTheyAre(0.4));
  ASSERT_GT(meshed.statistics.at("SmallCellsRemoved"), 20);
  const MeshArrays& mesh = meshed.mesh;
  for (std::size_t face = 0; face < mesh.boundaryIndex.size(); ++face)
  {
    const double x = middleOf(mesh, face)[0];
    if (std::abs(x) > 1e-6)
    {
      EXPECT_EQ(mesh.boundaryIndex[face], x > 0 ? 1 : 0) << "at x " << x;
    }
  }
}
