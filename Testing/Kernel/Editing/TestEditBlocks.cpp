// Walls edited in blocks: each cell once, zones apart from each other, and the same bits on any number of threads.
#include "Base/Error.h"
#include "Editing/EditBlocks.h"
#include "Editing/EditLoop.h"
#include "Editing/EditMeasures.h"
#include "Editing/WallOpening.h"
#include "Editing/WallSimplification.h"
#include "Support/MeshChecker.h"
#include "Support/WallCases.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <atomic>
#include <mutex>
#include <set>
#include <thread>

namespace cartesian
{

namespace
{

// Of many blocks.
std::vector<WallCase> cases()
{
  return { { "Ball", sphere(8, 0.7), 0.04, 0 }, { "BallRefined", sphere(8, 0.7), 0.14, 2 },
    { "Cube", cube().turned(), 0.03, 0 }, { "CubeRefined", cube().turned(), 0.11, 2 } };
}

class EditBlocksOf : public ::testing::TestWithParam<WallCase>
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

TEST_P(EditBlocksOf, NothingDependsOnThreadsOrTheOrderOfTriangles)
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

constexpr EditBlockSize Size{ 8, 2, ~std::uint32_t(0) };

// Nodes that are edited at the same time, by turn.
class NodesInUse
{
public:
  void take(const std::set<std::uint32_t>& nodes)
  {
    const std::lock_guard<std::mutex> lock(mutex_);
    for (const std::uint32_t n : nodes)
    {
      EXPECT_TRUE(used_.insert(n).second);
    }
  }
  void give(const std::set<std::uint32_t>& nodes)
  {
    const std::lock_guard<std::mutex> lock(mutex_);
    for (const std::uint32_t n : nodes)
    {
      used_.erase(n);
    }
  }

private:
  std::mutex mutex_;
  std::set<std::uint32_t> used_;
};

TEST_P(EditBlocksOf, EachCellOnceAndZonesShareNoNode)
{
  EditableWall wall = openedOf(GetParam());
  EditMesh& whole = wall.mesh.mesh();
  std::vector<std::atomic<int>> looked(whole.cells.size());
  std::atomic<int> blocks{ 0 };
  NodesInUse inUse;
  Execution execution(5);
  BlockEditing(whole, execution).edit(Size, [&](const ZoneTask& task) {
    for (const std::uint32_t c : task.cells)
    {
      EXPECT_TRUE(task.mesh.isFree(c));
      ++looked[c];
    }
    ++blocks;
    const std::set<std::uint32_t> nodes = nodesOf(task);
    inUse.take(nodes);
    std::this_thread::yield();
    inUse.give(nodes);
  });
  for (std::size_t c = 0; c < looked.size(); ++c)
  {
    ASSERT_EQ(looked[c], whole.cells[c].state == CellState::Free ? 1 : 0);
    ASSERT_EQ(whole.cells[c].zone, 0U);
  }
  EXPECT_GE(blocks, 8);
}

TEST_P(EditBlocksOf, OnlyWhatIsAskedForIsLookedAt)
{
  EditableWall wall = openedOf(GetParam());
  EditMesh& whole = wall.mesh.mesh();
  std::vector<std::uint32_t> asked;
  for (std::uint32_t c = 0; c < whole.cells.size(); c += 97)
  {
    whole.cells[c].state == CellState::Free ? asked.push_back(c) : void();
  }
  std::mutex mutex;
  std::vector<std::uint32_t> looked;
  Execution execution(2);
  BlockEditing(whole, execution).edit(asked, Size, [&](const ZoneTask& task) {
    const std::lock_guard<std::mutex> lock(mutex);
    looked.insert(looked.end(), task.cells.begin(), task.cells.end());
  });
  std::sort(looked.begin(), looked.end());
  EXPECT_EQ(looked, asked);
}

// Nodes of a long bar that was edited; cells beyond so many boxes from its end were frozen.
class Bar
{
public:
  explicit Bar(double frozenFrom)
  {
    const Soup soup = box({ 0.013, 0.017, 0.019 }, { 2.5, 0.08, 0.07 }).turned(0, 11);
    Execution execution;
    const auto a = cutCellsOf(soup, cellsOf(0.01), asTheyAre(), execution);
    EditableWall wall =
      openWall({ a->boxes, a->patches, a->sides, a->nodes, a->wall }, {}, execution);
    EditMesh& whole = wall.mesh.mesh();
    edge_ = whole.cells[0].edge;
    for (EditCell& cell : whole.cells)
    {
      if (cell.state == CellState::Free && cell.centre[0] > frozenFrom * edge_)
      {
        cell.state = CellState::Frozen;
      }
    }
    costAll(whole, ObjectiveSpec(), execution);
    BlockEditing blocks(whole, execution);
    blocks.edit(Size, [&](const ZoneTask& task) {
      simplifyWalls(task, SimplificationSpec(), { ObjectiveSpec() }, [] {});
      improve(task, LoopSpec(), [] {});
    });
    blocks.finish();
    for (const EditNode& node : whole.nodes)
    {
      node.gone ? void() : nodes_.push_back(node.at);
    }
    std::sort(nodes_.begin(), nodes_.end());
  }

  std::vector<Vector> until(double x) const
  {
    std::vector<Vector> some;
    std::copy_if(nodes_.begin(), nodes_.end(), std::back_inserter(some),
      [&](const Vector& at) { return at[0] < x * edge_; });
    return some;
  }

private:
  std::vector<Vector> nodes_;
  double edge_ = 1;
};

// Eight colours of blocks of eight boxes, each with two rings: what is farther away than that changes nothing.
TEST(EditBlocks, NothingDependsOnWhatIsFarAway)
{
  constexpr double Distance = 8 * (8 + 2 * 2);
  const Bar whole(1e9);
  const Bar cut(200);
  const std::vector<Vector> near = whole.until(200 - Distance);
  EXPECT_GT(near.size(), 1000U);
  EXPECT_TRUE(near == cut.until(200 - Distance));
  EXPECT_FALSE(whole.until(240) == cut.until(240));
}

// Numbers that do not fit are an error, not another list.
TEST(EditMesh, ListsThatDoNotFitAreRefused)
{
  EXPECT_EQ(listAt(7, 65535, 3).size, 65535);
  EXPECT_THROW(listAt(7, 65536, 3), Error);
  EXPECT_THROW(listAt((std::size_t(1) << 32) - 7, 8, 3), Error);
}

INSTANTIATE_TEST_SUITE_P(Shapes, EditBlocksOf, ::testing::ValuesIn(cases()), nameOfCase);

}

}
