// Cells split and merged: what may not change, and what has to.
#include "Support/Effort.h"
#include "Support/MeshChecker.h"
#include "Support/Pipeline.h"

#include <gtest/gtest.h>

namespace cartesian
{

namespace
{

TestOptions shaped(SmallCells smallCells, int threads = 1)
{
  TestOptions options = asTheyAre();
  options.shaping.splitConcave = true;
  options.smallCells.handling = smallCells;
  options.threads = threads;
  return options;
}

class ShapedMesh : public ::testing::TestWithParam<NamedShape>
{
};

// An L that lies in one box: arms of 0.3.
Soup ell()
{
  const std::vector<double> lines{ 0, 0.3, 1 };
  return voxels({ lines, lines, { 0, 1 } }, [](int i, int j, int) { return i == 0 || j == 0; });
}

}

TEST_P(ShapedMesh, KeepsVolumeAndAreasAndLeavesNoGap)
{
  const Soup& soup = GetParam().soup;
  for (const double cells : cases({ 8.0, 3.3 }))
  {
    SCOPED_TRACE(cells);
    for (const SmallCells mode : cases({ SmallCells::Remove, SmallCells::Merge }))
    {
      const MeshArrays mesh = meshOf(soup, cellsAlongLongest(soup, cells), shaped(mode)).mesh;
      EXPECT_TRUE(isValid(mesh, mode == SmallCells::Merge));
      EXPECT_TRUE(fills(mesh, soup));
    }
  }
}

TEST_P(ShapedMesh, KeepsVolumeAndAreasOfRefinedMeshes)
{
  const Soup& soup = GetParam().soup;
  TestOptions options = shaped(SmallCells::Merge);
  options.refinement = depth(2);
  const MeshArrays mesh = meshOf(soup, cellsAlongLongest(soup, 3.3), options).mesh;
  EXPECT_TRUE(isValid(mesh, true));
  EXPECT_TRUE(fills(mesh, soup));
}

INSTANTIATE_TEST_SUITE_P(Of, ShapedMesh, ::testing::ValuesIn(cleanShapes()), nameOf);

TEST(Shaping, AnEllInOneBoxIsSplitInTwo)
{
  const Meshed split = meshOf(ell(), cellsOf(1), shaped(SmallCells::Remove));
  EXPECT_EQ(split.mesh.cells(), 2U);
  EXPECT_EQ(split.statistics.at("CellsSplit"), 1);
  EXPECT_EQ(split.statistics.at("BoundaryAngleFailures"), 0);
  EXPECT_TRUE(isValid(split.mesh));
  EXPECT_TRUE(fills(split.mesh, ell()));

  const Meshed whole = meshOf(ell(), cellsOf(1));
  EXPECT_EQ(whole.mesh.cells(), 1U);
  EXPECT_GT(whole.statistics.at("BoundaryAngleFailures"), 0);
}

// Equation 6: the plane halves the angle at the concave edge, wherever it ends then. Arms of 0.25 and 0.4, so
// that it ends beside the far corner.
TEST(Shaping, ACutHalvesTheConcaveAngle)
{
  const Soup uneven = voxels({ std::vector<double>{ 0, 0.25, 1 }, { 0, 0.4, 1 }, { 0, 1 } },
    [](int i, int j, int) { return i == 0 || j == 0; });
  const Meshed split = meshOf(uneven, cellsOf(1), shaped(SmallCells::Remove));
  ASSERT_EQ(split.mesh.cells(), 2U);
  const auto pointsNear = [&](double x, double y) {
    int count = 0;
    for (std::size_t p = 0; p < split.mesh.points.size(); p += 3)
    {
      count +=
        std::abs(split.mesh.points[p] - x) < 1e-6 && std::abs(split.mesh.points[p + 1] - y) < 1e-6;
    }
    return count;
  };
  EXPECT_GE(pointsNear(0.25, 0.4), 2);
  EXPECT_GE(pointsNear(0, 0.15), 2) << "at 45 degrees from the concave edge";
  EXPECT_TRUE(isValid(split.mesh));
  EXPECT_TRUE(fills(split.mesh, uneven));
}

TEST(Shaping, ASlabIsMergedIntoTheCellsBelow)
{
  // 3 x 3 x 1 boxes filled, and a slab of a hundredth of a box above them.
  const Soup soup = box({ 0, 0, 0 }, { 3, 3, 1.01 });
  GridSpec grid = cellsOf(1);
  grid.meshlines = { std::vector<double>{ 0, 1, 2, 3 }, { 0, 1, 2, 3 }, { 0, 1, 2 } };
  const Meshed apart = meshOf(soup, grid);
  const Meshed merged = meshOf(soup, grid, shaped(SmallCells::Merge));
  EXPECT_EQ(apart.mesh.cells(), 18U);
  EXPECT_EQ(merged.mesh.cells(), 9U);
  EXPECT_EQ(merged.statistics.at("SmallCellsMerged"), 9);
  EXPECT_TRUE(isValid(merged.mesh, true));
  EXPECT_TRUE(fills(merged.mesh, soup));
}

// Where corners of boxes move onto a crease, a cell must not end on its other side.
TEST(Shaping, CollapsedEdgesKeepTheVolumeOfExactFit)
{
  TestOptions options = asTheyAre();
  for (unsigned seed = 0; seed < repeats(40); ++seed)
  {
    SCOPED_TRACE(seed);
    const Soup soup = starPolyhedron(seed, 3);
    options.collapse.ratio = seed % 2 == 0 ? 0.1 : ShortEdgeSpec::Ratios.most;
    const MeshArrays mesh = meshOf(soup, cellsAlongLongest(soup, 12.3 + seed), options).mesh;
    EXPECT_TRUE(isValid(mesh, true));
    EXPECT_TRUE(fills(mesh, soup));
  }
}

TEST(Shaping, FuzzedShapesStayValid)
{
  for (unsigned seed = 0; seed < repeats(12); ++seed)
  {
    SCOPED_TRACE(seed);
    const Soup soup = seed % 2 == 0 ? starPolyhedron(seed, 6) : bumpySphere(seed, 4);
    const MeshArrays mesh = meshOf(soup, cellsAlongLongest(soup, 2.3 + seed),
      shaped(SmallCells::Merge, 1 + static_cast<int>(seed % 3)))
                              .mesh;
    EXPECT_TRUE(isValid(mesh, true));
    EXPECT_TRUE(fills(mesh, soup));
  }
}

}
