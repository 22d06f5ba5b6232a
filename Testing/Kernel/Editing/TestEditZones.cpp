// Walls edited in zones: each cell once, zones apart from each other, and the same bits on any number of threads.
#include "Base/Error.h"
#include "Editing/EditZones.h"
#include "Editing/WallOpening.h"
#include "Support/MeshChecker.h"
#include "Support/WallCases.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <map>
#include <set>

namespace cartesian
{

namespace
{

// Of more than 9216 cells at the wall: three zones.
std::vector<WallCase> cases()
{
  return { { "Ball", sphere(8, 0.7), 0.04, 0 }, { "BallRefined", sphere(8, 0.7), 0.14, 2 },
    { "Cube", cube().turned(), 0.03, 0 }, { "CubeRefined", cube().turned(), 0.11, 2 } };
}

class EditZonesOf : public ::testing::TestWithParam<WallCase>
{
};

Soup reversed(Soup soup)
{
  std::reverse(soup.triangles.begin(), soup.triangles.end());
  std::reverse(soup.boundary.begin(), soup.boundary.end());
  return soup;
}

MeshArrays editedOf(const Soup& soup, const WallCase& one, int threads)
{
  Execution execution(threads);
  const auto assembly = assembledOf(soup, cellsOf(one.size), optionsInPlace(one), execution);
  return arraysOf(*assembly->mesh, assembly->boxes, execution);
}

TEST_P(EditZonesOf, NothingDependsOnThreadsOrTheOrderOfTriangles)
{
  const WallCase& one = GetParam();
  const MeshArrays alone = editedOf(one.soup, one, 1);
  EXPECT_TRUE(alone == editedOf(one.soup, one, 2));
  EXPECT_TRUE(alone == editedOf(reversed(one.soup), one, 5));
}

EditableWall openedOf(const WallCase& one)
{
  const TestOptions options = asTheyAre(0, depth(one.levels));
  Execution execution;
  const auto a = cutCellsOf(one.soup, cellsOf(one.size), options, execution);
  return openWall({ a->boxes, a->patches, a->sides, a->nodes, a->wall }, {}, execution);
}

// The nodes of the cells that an editor may change.
std::set<std::uint32_t> nodesOf(const ZoneTask& task)
{
  std::set<std::uint32_t> nodes;
  for (const std::uint32_t c : task.zone)
  {
    for (std::size_t i = 0; task.mesh.isFree(c) && i < task.mesh.facesOf(c).size(); ++i)
    {
      const Items corners = task.mesh.cornersOf(task.mesh.facesOf(c)[i]);
      nodes.insert(corners.begin(), corners.end());
    }
  }
  return nodes;
}

TEST_P(EditZonesOf, EachCellOnceAndZonesShareNoNode)
{
  EditableWall wall = openedOf(GetParam());
  EditMesh& whole = wall.mesh.mesh();
  std::vector<int> looked(whole.cells.size());
  std::map<std::ptrdiff_t, std::vector<std::set<std::uint32_t>>> rounds; // by cells that are over
  Execution execution;
  editInZones(whole, execution, [&](const ZoneTask& task) {
    for (const std::uint32_t c : task.cells)
    {
      EXPECT_TRUE(task.mesh.isFree(c));
      ++looked[c];
    }
    rounds[std::count(task.isDone.begin(), task.isDone.end(), 1)].push_back(nodesOf(task));
  });
  for (std::size_t c = 0; c < looked.size(); ++c)
  {
    ASSERT_EQ(looked[c], whole.cells[c].state == CellState::Free ? 1 : 0);
    ASSERT_EQ(whole.cells[c].zone, 0U);
  }
  EXPECT_GE(rounds.begin()->second.size(), 3U);
  for (const auto& round : rounds)
  {
    std::set<std::uint32_t> all;
    std::size_t count = 0;
    for (const std::set<std::uint32_t>& nodes : round.second)
    {
      all.insert(nodes.begin(), nodes.end());
      count += nodes.size();
    }
    EXPECT_EQ(all.size(), count);
  }
}

// Numbers that do not fit are an error, not another list.
TEST(EditMesh, ListsThatDoNotFitAreRefused)
{
  EXPECT_EQ(listAt(7, 65535, 3).size, 65535);
  EXPECT_THROW(listAt(7, 65536, 3), Error);
  EXPECT_THROW(listAt((std::size_t(1) << 32) - 7, 8, 3), Error);
}

INSTANTIATE_TEST_SUITE_P(Shapes, EditZonesOf, ::testing::ValuesIn(cases()), nameOfCase);

}

}
