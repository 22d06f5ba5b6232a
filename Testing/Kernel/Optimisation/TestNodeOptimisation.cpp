// SPDX-License-Identifier: BSD-3-Clause
// Nodes at the wall move along it, for the better.
#include "Support/MeshChecker.h"
#include "Support/Pipeline.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <set>

namespace cartesian
{

namespace
{

// What solvers refuse stays, so that nothing but moving nodes makes a difference.
Meshed meshed(const Soup& soup, double cells, bool optimises)
{
  TestOptions options;
  options.shaping.editsInPlace = false;
  options.shaping.optimiseNodes = optimises;
  options.shaping.refusedCellRatio = 0;
  return meshOf(soup, cellsAlongLongest(soup, cells), options);
}

std::set<std::array<double, 3>> placesOf(const MeshArrays& mesh)
{
  std::set<std::array<double, 3>> places;
  for (std::size_t i = 0; i < mesh.points.size(); i += 3)
  {
    places.insert({ mesh.points[i], mesh.points[i + 1], mesh.points[i + 2] });
  }
  return places;
}

// How many points are where none was before.
std::size_t movedPoints(const MeshArrays& before, const MeshArrays& after)
{
  const auto were = placesOf(before);
  const auto are = placesOf(after);
  return static_cast<std::size_t>(
    std::count_if(are.begin(), are.end(), [&](const auto& at) { return were.count(at) == 0; }));
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
    EXPECT_EQ(before.cells(), after.cells());
    EXPECT_LE(after.points.size(), before.points.size());
    EXPECT_GT(movedPoints(before, after), before.points.size() / 12);
  }
}

TEST(NodeOptimisation, LeavesWhatTheGridFitsAlone)
{
  const MeshArrays before = meshed(cube(), 8, false).mesh;
  const MeshArrays after = meshed(cube(), 8, true).mesh;
  EXPECT_EQ(before.points, after.points);
}

// Points and faces become fewer, but no cell goes.
TEST(NodeOptimisation, KeepsCellsAndVolume)
{
  const Soup soup = bumpySphere(3, 12);
  const MeshArrays before = meshed(soup, 8, false).mesh;
  const MeshArrays after = meshed(soup, 8, true).mesh;
  EXPECT_TRUE(isValid(after, true));
  EXPECT_EQ(before.cells(), after.cells());
  EXPECT_LE(after.points.size(), before.points.size());
  EXPECT_LE(after.boundaryCell.size(), before.boundaryCell.size());
  EXPECT_NEAR(volumeOf(after), volumeOf(before), 3e-3 * volumeOf(before));
}

}
