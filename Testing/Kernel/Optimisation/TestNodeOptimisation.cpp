// SPDX-License-Identifier: BSD-3-Clause
// Nodes at the wall move along it, for the better.
#include "Support/MeshChecker.h"
#include "Support/Pipeline.h"

#include <gtest/gtest.h>

#include <algorithm>

namespace cartesian
{

namespace
{

// What solvers refuse stays, so that nothing but moving nodes makes a difference.
Meshed meshed(const Soup& soup, double cells, bool optimises)
{
  TestOptions options;
  options.shaping.optimiseNodes = optimises;
  options.shaping.refusedCellRatio = 0;
  return meshOf(soup, cellsAlongLongest(soup, cells), options);
}

std::size_t movedPoints(const MeshArrays& a, const MeshArrays& b)
{
  std::size_t moved = 0;
  for (std::size_t i = 0; i < a.points.size(); i += 3)
  {
    moved += std::equal(a.points.begin() + std::ptrdiff_t(i),
               a.points.begin() + std::ptrdiff_t(i + 3), b.points.begin() + std::ptrdiff_t(i))
      ? 0
      : 1;
  }
  return moved;
}

}

TEST(NodeOptimisation, MovesNodesAlongPlanesAndEdgesOnly)
{
  for (const Soup& soup : { cube().turned(), octahedron(1).turned(),
         tetrahedron({ { { 0, 0, 0 }, { 1, 0, 0.1 }, { 0.2, 1, 0 }, { 0.1, 0.3, 1 } } }) })
  {
    const MeshArrays before = meshed(soup, 9, false).mesh;
    const MeshArrays after = meshed(soup, 9, true).mesh;
    EXPECT_TRUE(isValid(after, true));
    EXPECT_NEAR(volumeOf(after), volumeOf(before), 1e-6 * volumeOf(before));
    ASSERT_EQ(before.points.size(), after.points.size());
    EXPECT_GT(movedPoints(before, after), before.points.size() / 12);
  }
}

TEST(NodeOptimisation, LeavesWhatTheGridFitsAlone)
{
  const MeshArrays before = meshed(cube(), 8, false).mesh;
  const MeshArrays after = meshed(cube(), 8, true).mesh;
  EXPECT_EQ(before.points, after.points);
}

TEST(NodeOptimisation, KeepsConnectivityAndVolume)
{
  const Soup soup = bumpySphere(3, 12);
  const MeshArrays before = meshed(soup, 8, false).mesh;
  const MeshArrays after = meshed(soup, 8, true).mesh;
  EXPECT_TRUE(isValid(after, true));
  EXPECT_EQ(before.offsets, after.offsets);
  EXPECT_EQ(before.boundaryCell, after.boundaryCell);
  EXPECT_NEAR(volumeOf(after), volumeOf(before), 3e-3 * volumeOf(before));
}

}
