// Small cells at the wall become part of a neighbour, or go; others stay as they are, bit for bit.
#include "Editing/SmallCells.h"
#include "Support/Turned.h"

#include <gtest/gtest.h>

namespace cartesian
{

namespace
{

constexpr double Thin = 1.0 / 64;
constexpr double Rounding = 1e-14; // of volumes of boxes

// 3 x 3 boxes, and 3 x 3 thin ones on them.
MeshEditor thinTop(const Turn& turn = {})
{
  return turnedMesh(turn, blockOfBoxes(3, 3, 2), [](const Vector& p) {
    return Vector{ p[0], p[1], p[2] < 2 ? p[2] : 1 + Thin };
  });
}

constexpr std::uint32_t Top = 9; // in the middle
constexpr std::uint32_t Below = 8;

struct Taker
{
  EditRules rules;
  bool removes = true;

  std::vector<MadeEdit> take(MeshEditor& mesh, const std::vector<std::uint32_t>& cells) const
  {
    std::vector<MadeEdit> edits;
    mergeOrRemoveSmallCells(WholeTask(mesh, cells).task(), rules, removes, edits);
    EXPECT_EQ(faultOf(mesh), "");
    return edits;
  }
};

Taker withoutMerging(bool removes = true)
{
  Taker taker;
  taker.rules.mostMerged = 0;
  taker.removes = removes;
  return taker;
}

}

// The cell below has 1 in common with it, each beside it a 64th.
TEST(SmallCells, MergeWithTheCellBelow)
{
  for (const Turn& turn : turns())
  {
    MeshEditor mesh = thinTop(turn);
    mesh.mesh().small.ratio = 1.0 / 32;
    const std::uint32_t top = cellAt(mesh, turn({ 1.5, 1.5, 1 + Thin / 2 }));
    const std::uint32_t below = cellAt(mesh, turn({ 1.5, 1.5, 0.5 }));
    ASSERT_EQ(largestNeighbours(mesh, top)[0], below);
    const std::vector<MadeEdit> edits = Taker().take(mesh, { top });
    ASSERT_EQ(edits.size(), 1U);
    EXPECT_EQ(edits[0].kind, EditKind::Merge);
    EXPECT_TRUE(mesh.cell(top).gone);
    EXPECT_EQ(countCells(mesh), 17U);
    EXPECT_NEAR(mesh.cell(below).volume, 1 + Thin, Rounding);
    EXPECT_NEAR(volumeOf(mesh, below), 1 + Thin, Rounding);
    EXPECT_NEAR(volumeOf(mesh), 9 * (1 + Thin), 9 * Rounding);
    EXPECT_NEAR(sumOfDeficits(mesh), 0, Rounding);
    for (std::uint32_t c = 0; c < mesh.cellCount(); ++c)
    {
      if (!mesh.cell(c).gone && c != below)
      {
        const bool isThin =
          mesh.cell(c).centre[(2 + turn.axes) % 3] > turn.by[(2 + turn.axes) % 3] + 1;
        EXPECT_NEAR(mesh.cell(c).volume, isThin ? Thin : 1, Rounding) << c;
      }
    }
  }
}

TEST(SmallCells, AllMergeAndNoVolumeIsLost)
{
  for (const Turn& turn : turns())
  {
    MeshEditor mesh = thinTop(turn);
    mesh.mesh().small.ratio = 1.0 / 32;
    std::vector<std::uint32_t> cells(mesh.cellCount());
    for (std::uint32_t c = 0; c < cells.size(); ++c)
    {
      cells[c] = c;
    }
    const std::vector<MadeEdit> edits = Taker().take(mesh, cells);
    EXPECT_EQ(edits.size(), 9U);
    EXPECT_EQ(countCells(mesh), 9U);
    EXPECT_NEAR(volumeOf(mesh), 9 * (1 + Thin), 9 * Rounding);
    EXPECT_NEAR(volumeBehindWalls(mesh), volumeOf(mesh), 1e-11);
    for (std::uint32_t c = 0; c < mesh.cellCount(); ++c)
    {
      EXPECT_TRUE(mesh.cell(c).gone || mesh.cell(c).volume > 0.999) << c;
    }
  }
}

// None beyond the ratio, or its boundary's, whatever it would gain.
TEST(SmallCells, LargerOnesStay)
{
  MeshEditor mesh = thinTop();
  const MeshEditor before = copyOf(mesh);
  for (const Taker& taker : { Taker(), withoutMerging() })
  {
    mesh.mesh().small.ratio = 1.0 / 65;
    EXPECT_TRUE(taker.take(mesh, { Top, Below, 0, 1 }).empty());
    mesh.mesh().small.ratio = 1.0 / 32;
    EXPECT_TRUE(taker.take(mesh, { Below, 0, 16 }).empty());
    mesh.mesh().small.boundaryRatios = { { mesh.cell(Top).wall, 1.0 / 65 } };
    EXPECT_TRUE(taker.take(mesh, { Top }).empty());
    mesh.mesh().small.boundaryRatios.clear();
    EXPECT_EQ(differenceOf(mesh, before), "");
  }
}

TEST(SmallCells, GoByTheBoundarysOwnRatio)
{
  MeshEditor mesh = thinTop();
  mesh.mesh().small.ratio = 0;
  mesh.rawCell(Top).wall = 5;
  mesh.mesh().small.boundaryRatios = { { 5, 1.0 / 32 } };
  EXPECT_EQ(Taker().take(mesh, { Top, 7 }).size(), 1U);
  EXPECT_TRUE(mesh.cell(Top).gone);
}

// What they held is missing from then on: the walls owe it, and the edit says so.
TEST(SmallCells, GoWhereNoneMerge)
{
  for (const Turn& turn : turns())
  {
    MeshEditor mesh = thinTop(turn);
    mesh.mesh().small.ratio = 1.0 / 32;
    const std::uint32_t top = cellAt(mesh, turn({ 1.5, 1.5, 1 + Thin / 2 }));
    const std::uint32_t below = cellAt(mesh, turn({ 1.5, 1.5, 0.5 }));
    const std::vector<MadeEdit> edits = withoutMerging().take(mesh, { top });
    ASSERT_EQ(edits.size(), 1U);
    EXPECT_EQ(edits[0].kind, EditKind::Remove);
    EXPECT_NEAR(edits[0].removed * std::pow(mesh.level(), 3), Thin, Rounding);
    EXPECT_TRUE(mesh.cell(top).gone);
    EXPECT_EQ(countCells(mesh), 17U);
    EXPECT_NEAR(mesh.cell(below).volume, 1, Rounding);
    EXPECT_NEAR(volumeOf(mesh), 9 * (1 + Thin) - Thin, 9 * Rounding);
    EXPECT_NEAR(sumOfDeficits(mesh), Thin, 1e-11);
  }
}

TEST(SmallCells, StayWhereNoneMergeAndNoneGo)
{
  MeshEditor mesh = thinTop();
  mesh.mesh().small.ratio = 1.0 / 32;
  MeshEditor before = copyOf(mesh);
  EXPECT_TRUE(withoutMerging(false).take(mesh, { Top }).empty());
  EXPECT_EQ(differenceOf(mesh, before), "");
  // Frozen ones do not change at all.
  mesh.rawCell(Top).state = CellState::Frozen;
  before = copyOf(mesh);
  EXPECT_TRUE(Taker().take(mesh, { Top }).empty());
  EXPECT_EQ(differenceOf(mesh, before), "");
}

}
