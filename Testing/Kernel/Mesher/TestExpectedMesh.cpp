// How large a mesh will be, against how large it is.
#include "Mesher/ExpectedMesh.h"

#include "Boxes/MeshEstimate.h"
#include "Support/MeshChecker.h"

#include <gtest/gtest.h>

#include <cmath>

using namespace cartesian;

namespace
{

double madeOf(const Soup& soup, const TestOptions& options)
{
  Execution execution(1);
  const auto made = mesh(soup.view(), options, execution);
  return static_cast<double>(made->mesh->cellCount()) +
    (made->layers ? static_cast<double>(made->layers->stacks.cells()) : 0);
}

TestOptions sized(double cellSize)
{
  TestOptions options;
  options.grid = cellsOf(cellSize);
  return options;
}

}

TEST(ExpectedMesh, RowsAreSortedAndOneIsAsked)
{
  const Soup soup = sphere(20, 1);
  Execution execution(1);
  for (const double size : { 0.0, 0.05, 0.04, 5.0 })
  {
    const std::vector<ExpectedRow> rows = expectedRows(soup.view(), sized(size), execution);
    EXPECT_EQ(rows.size(), size == 0 || size == 0.04 ? 4U : 5U);
    int asked = 0;
    for (std::size_t i = 0; i < rows.size(); ++i)
    {
      const ExpectedMesh& mesh = rows[i].mesh;
      asked += rows[i].isAsked ? 1 : 0;
      EXPECT_TRUE(!rows[i].isAsked || size == 0 || mesh.size == size);
      EXPECT_GE(mesh.cells, 1);
      EXPECT_LE(mesh.cells, mesh.boxes);
      if (i > 0)
      {
        EXPECT_LT(mesh.size, rows[i - 1].mesh.size);
        EXPECT_GE(mesh.boxes, rows[i - 1].mesh.boxes);
        EXPECT_GT(mesh.bytes, rows[i - 1].mesh.bytes);
      }
    }
    EXPECT_EQ(asked, 1);
  }
}

TEST(ExpectedMesh, AsManyCellsAreMade)
{
  for (const Soup& soup : { sphere(30, 1), torus(40, 1, 0.4), cube().turned() })
  {
    for (const int layers : { 0, 3 })
    {
      TestOptions options = sized(0.06);
      options.layers.count = layers;
      Execution execution(1);
      const double expected = expectedMesh(soup.view(), options, execution).cells;
      EXPECT_NEAR(expected / madeOf(soup, options), 1, 0.25) << layers << " layers";
    }
  }
}

TEST(ExpectedMesh, RefinementForLayersCounts)
{
  const Soup soup = torus(40, 1, 0.25).turned();
  TestOptions options = sized(0.1);
  options.layers.count = 3;
  options.layers.firstThickness = 1e-3;
  Execution execution(1);
  const double refined = expectedMesh(soup.view(), options, execution).cells;
  EXPECT_NEAR(refined / madeOf(soup, options), 1, 0.3);
  options.layers.refine = false;
  EXPECT_GT(refined, 1.5 * expectedMesh(soup.view(), options, execution).cells);
}

TEST(ExpectedMesh, BoundariesWithoutLayersHaveNone)
{
  const Soup soup = sphere(20, 1);
  TestOptions options = sized(0.1);
  Execution execution(1);
  const double without = expectedMesh(soup.view(), options, execution).cells;
  options.layers.count = 4;
  const double with = expectedMesh(soup.view(), options, execution).cells;
  for (std::size_t t = 0; t < soup.view().triangleCount; ++t)
  {
    options.layers.boundaries.push_back({ soup.boundaryOf(t), 0 });
  }
  EXPECT_GT(with, 2 * without);
  EXPECT_NEAR(expectedMesh(soup.view(), options, execution).cells / without, 1, 0.02);
}

// The sharp edges lie along the ends: in few of the layers, or in one.
TEST(ExpectedMesh, KnowsWhereSizesAskForBoxes)
{
  for (const double size : { 1.0, 0.5, 0.25, 0.125 })
  {
    const Soup soup = box({ 0, 0, 0 }, { 1, 1, 2 });
    TestOptions options = sized(size);
    options.refinement.sizing.featureDepth = 4;
    Execution execution(1);
    const double expected = expectedMesh(soup.view(), options, execution).cells;
    EXPECT_NEAR(std::log2(expected / madeOf(soup, options)), 0, 1) << size;
  }
}

// A region of a thousandth of a global box takes few boxes, however deep they are.
TEST(ExpectedMesh, SmallRegionsTakeFewBoxes)
{
  Depths depths;
  for (const int depth : { 3, 6, 9, 12 })
  {
    depths.touched = depth;
    const double share = 1000 * std::pow(8, -depth);
    const MeshEstimate small =
      estimateBox(BoxStatus::Inside, depths, { { depth, std::min(0.5, share) } }, 1, {}, {});
    EXPECT_LE(small.boxes(), 1001) << depth;
    const MeshEstimate half = estimateBox(BoxStatus::Inside, depths, { { depth, 0.5 } }, 1, {}, {});
    EXPECT_NEAR(half.boxes() / std::pow(8, depth), 0.5, 1e-3) << depth;
  }
}
