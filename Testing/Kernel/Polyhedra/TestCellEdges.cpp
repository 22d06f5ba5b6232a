// Cells edge by edge: gaps, and the angle at the most concave edge.
#include "Polyhedra/CellEdges.h"
#include "Polyhedra/CellGeometry.h"

#include <gtest/gtest.h>

using namespace cartesian;

namespace
{

// A prism of height 1 over a polygon, counter-clockwise in x and y; optionally without its top.
CellEdges::Result measurePrism(const std::vector<Vector>& polygon, bool hasTop = true)
{
  const auto n = static_cast<std::uint32_t>(polygon.size());
  std::vector<std::vector<std::uint32_t>> faces(2);
  for (std::uint32_t i = 0; i < n; ++i)
  {
    const std::uint32_t next = (i + 1) % n;
    faces[0].insert(faces[0].begin(), i);
    faces[1].push_back(n + i);
    faces.push_back({ i, next, n + next, n + i });
  }
  if (!hasTop)
  {
    faces.erase(faces.begin() + 1);
  }
  const auto position = [&](std::uint32_t node) {
    return plus(polygon[node % n], Vector{ 0, 0, node < n ? 0.0 : 1.0 });
  };
  CellEdges edges;
  for (const auto& face : faces)
  {
    const Vector area =
      measureFace(face.size(), [&](std::size_t i) { return position(face[i]); }).area;
    for (std::size_t i = 0; i < face.size(); ++i)
    {
      edges.add(face[i], face[(i + 1) % face.size()], area);
    }
  }
  return edges.measure(position);
}

const std::vector<Vector> Square = { { 0, 0, 0 }, { 1, 0, 0 }, { 1, 1, 0 }, { 0, 1, 0 } };

}

TEST(CellEdges, CubeIsClosedAndConvex)
{
  const CellEdges::Result cube = measurePrism(Square);
  EXPECT_EQ(cube.open, 0u);
  EXPECT_EQ(cube.concavity, 0);
}

TEST(CellEdges, MissingFaceOpensItsEdges)
{
  EXPECT_EQ(measurePrism(Square, false).open, 4u);
}

TEST(CellEdges, CoplanarFacesAreNotConcave)
{
  std::vector<Vector> split = Square;
  split.insert(split.begin() + 1, { 0.3, 0, 0 });
  const CellEdges::Result cube = measurePrism(split);
  EXPECT_EQ(cube.open, 0u);
  EXPECT_EQ(cube.concavity, 0);
}

TEST(CellEdges, NotchHasTheAngleItWasGiven)
{
  for (const double degrees : { 1.0, 30.0, 90.0, 150.0 })
  {
    // The corner in the middle of the upper edge is pushed down until the edge bends by `degrees`.
    const double drop = std::tan(radians(degrees / 2));
    const CellEdges::Result cell =
      measurePrism({ { -1, -9, 0 }, { 1, -9, 0 }, { 1, 0, 0 }, { 0, -drop, 0 }, { -1, 0, 0 } });
    EXPECT_EQ(cell.open, 0u);
    EXPECT_NEAR(cell.concavity, degrees, 1e-9);
  }
}
