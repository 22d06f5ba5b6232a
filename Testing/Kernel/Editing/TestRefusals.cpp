// What solvers refuse is counted as edits change it, and taken apart.
#include "Editing/RefusalEnding.h"
#include "Editing/RefusalSearch.h"
#include "Support/EditMeshes.h"

#include <gtest/gtest.h>

#include <algorithm>

namespace cartesian
{

namespace
{

// A cell around the rim of a slot that is one box wide: its walls on either side look at each other across it, and its
// centre is in the slot.
MeshEditor aroundARim()
{
  std::vector<TestBox> boxes;
  for (int x = 0; x < 5; ++x)
  {
    for (const int z : { 0, 1, 2 })
    {
      if (z != 1 || x == 4)
      {
        boxes.push_back({ { x, 0, z }, { x + 1, 1, z + 1 } });
      }
    }
  }
  return cellOfBoxes(boxes);
}

int invertedSides(const MeshEditor& mesh)
{
  int count = 0;
  for (std::uint32_t c = 0; c < mesh.cellCount(); ++c)
  {
    count += mesh.cell(c).gone ? 0 : refusalsIn(mesh, c).inverted;
  }
  return count;
}

std::vector<std::uint32_t> allCells(const MeshEditor& mesh)
{
  std::vector<std::uint32_t> cells;
  for (std::uint32_t c = 0; c < mesh.cellCount(); ++c)
  {
    if (mesh.isFree(c))
    {
      cells.push_back(c);
    }
  }
  return cells;
}

std::vector<MadeEdit> endAll(MeshEditor& mesh, const EditRules& rules = {}, bool removes = true)
{
  std::vector<RemovedPiece> removed;
  std::vector<MadeEdit> edits;
  endRefusals(WholeTask(mesh, allCells(mesh)).task(), rules, removes, removed, edits, [] {});
  return edits;
}

}

TEST(Refusals, CellsAroundRimsAreTakenApartWithoutLoss)
{
  MeshEditor mesh = aroundARim();
  const double volume = volumeOf(mesh);
  ASSERT_GT(invertedSides(mesh), 0);
  ASSERT_TRUE(isRefused(mesh, 0));
  const std::vector<MadeEdit> edits = endAll(mesh);
  EXPECT_EQ(invertedSides(mesh), 0);
  EXPECT_EQ(faultOf(mesh), "");
  EXPECT_NEAR(volumeOf(mesh), volume, 1e-12);
  EXPECT_GT(countCells(mesh), 1);
  ASSERT_EQ(edits.size(), 1);
  EXPECT_EQ(edits[0].kind, EditKind::Cut);
}

TEST(Refusals, GoodCellsStayAsTheyAre)
{
  MeshEditor mesh = meshOfBoxes(blockOfBoxes(2, 2, 2));
  const MeshEditor before = copyOf(mesh);
  EXPECT_EQ(invertedSides(mesh), 0);
  EXPECT_TRUE(endAll(mesh).empty());
  EXPECT_EQ(differenceOf(mesh, before), "");
}

// Two flaps with nothing between their walls hang on a wedge, one on the other: neither may be left alone.
TEST(Refusals, FlapsGoWithWhatHangsOnThem)
{
  constexpr double Thickness = 1e-6;
  TestMeshSpec spec;
  spec.place = [](const Vector& p) {
    return Vector{ p[0], p[1], p[0] < 2 ? p[2] : Thickness * p[2] };
  };
  MeshEditor mesh = meshOfBoxes(blockOfBoxes(4, 1, 1), spec);
  const auto flaps = [&] {
    const std::vector<std::uint32_t> cells = allCells(mesh);
    return std::count_if(cells.begin(), cells.end(), [&](std::uint32_t c) {
      EXPECT_EQ(hasNoVolume(mesh, c), isDegenerate(mesh, c));
      return hasNoVolume(mesh, c);
    });
  };
  ASSERT_EQ(flaps(), 2);
  EditRules rules;
  rules.mostMerged = 0; // by volume, they could go to their neighbours
  const std::vector<MadeEdit> edits = endAll(mesh, rules);
  EXPECT_EQ(flaps(), 0);
  EXPECT_EQ(faultOf(mesh), "");
  EXPECT_NEAR(volumeOf(mesh), 1.5, 3 * Thickness);
  EXPECT_EQ(std::count_if(edits.begin(), edits.end(),
              [](const MadeEdit& edit) {
                return edit.kind == EditKind::Remove && edit.reason == RemovalReason::Rim;
              }),
    2);
}

TEST(Refusals, WithoutCutsMergesAndRemovalOnlyFacesAreJoined)
{
  MeshEditor mesh = aroundARim();
  const double volume = volumeOf(mesh);
  EditRules rules;
  rules.mayCut = false;
  rules.mostMerged = 0;
  EXPECT_TRUE(endAll(mesh, rules, false).empty());
  EXPECT_EQ(faultOf(mesh), "");
  EXPECT_EQ(countCells(mesh), 1);
  EXPECT_NEAR(volumeOf(mesh), volume, 1e-12);
  EXPECT_GT(invertedSides(mesh), 0); // nothing else could end that
}

TEST(Refusals, TheLedgerCountsThem)
{
  MeshEditor mesh = aroundARim();
  const int before = invertedSides(mesh);
  const EditRules rules;
  RefusedPieces pieces(mesh, rules);
  pieces.begin(0);
  const RefusalPlan plan = searchRefusals(pieces, SearchBudget());
  EXPECT_EQ(invertedSides(mesh), before); // a search changes nothing
  const MeshEditor::Mark mark = mesh.mark();
  for (const RefusalEdit& edit : plan)
  {
    ASSERT_TRUE(pieces.make(edit));
    EXPECT_EQ(mesh.delta.inverted, invertedSides(mesh) - before);
  }
  mesh.undo(mark);
  EXPECT_EQ(mesh.delta.inverted, 0);
}

// In order of rank.
TEST(Refusals, LessIsLess)
{
  const Refusals some{ 1, 1, 1, 1 };
  EXPECT_LT((Refusals{ 0, 9, 9, 9 }), some);
  EXPECT_LT((Refusals{ 1, 0, 9, 9 }), some);
  EXPECT_LT((Refusals{ 1, 1, 0.5, 9 }), some);
  EXPECT_LT((Refusals{ 1, 1, 1, 0 }), some);
  EXPECT_FALSE(some < some);
  EXPECT_TRUE((Refusals{ 1, 1, 9, 9 }).isWithin(some));
  EXPECT_FALSE((Refusals{ 0, 2, 0, 0 }).isWithin(some));
}

}
