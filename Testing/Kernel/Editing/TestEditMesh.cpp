// Lists and the journal of the editable mesh, on meshes made by hand.
#include "Editing/CellClosure.h"
#include "Editing/CellCut.h"
#include "Editing/EditDecision.h"
#include "Editing/EditMeasures.h"
#include "Support/EditMeshes.h"
#include "Support/RandomEdits.h"

#include <gtest/gtest.h>

namespace cartesian
{

namespace
{

using Numbers = std::vector<std::uint32_t>;

// One cell of tetrahedra: three corners, and an apex.
MeshEditor cellOfTetrahedra(
  std::uint32_t nodes, const std::vector<std::array<std::uint32_t, 4>>& all)
{
  MeshEditor mesh;
  for (std::uint32_t n = 0; n < nodes; ++n)
  {
    mesh.addNode({});
  }
  mesh.addCell({});
  for (const auto& [a, b, c, d] : all)
  {
    for (const Numbers& ring : { Numbers{ a, c, b }, { a, b, d }, { b, c, d }, { c, a, d } })
    {
      EditFace face;
      face.below = 0;
      face.wall = 0;
      mesh.addFace(face, ring.data(), ring.size());
    }
  }
  mesh.connect();
  return mesh;
}

}

TEST(MeshEditor, ListsWhatIsThere)
{
  const MeshEditor mesh = meshOfBoxes(blockOfBoxes(2, 3, 4));
  EXPECT_EQ(mesh.nodeCount(), 60);
  EXPECT_EQ(mesh.cellCount(), 24);
  EXPECT_EQ(mesh.faceCount(), 3 * 24 + 12 + 8 + 6);
  EXPECT_EQ(faultOf(mesh), "");
  EXPECT_EQ(volumeOf(mesh), 24);
  EXPECT_EQ(volumeBehindWalls(mesh), 24);
  EXPECT_EQ(mesh.facesAround(nodeAt(mesh, { 0, 0, 0 })).size(), 3);
  EXPECT_EQ(mesh.facesAround(nodeAt(mesh, { 1, 1, 1 })).size(), 12);
  EXPECT_FALSE(mesh.node(nodeAt(mesh, { 1, 1, 1 })).atWall);
  EXPECT_EQ(mesh.node(nodeAt(mesh, { 1, 1, 1 })).kind, NodeKind::Free);
  EXPECT_EQ(mesh.node(nodeAt(mesh, { 1, 1, 0 })).kind, NodeKind::OnSurface);
  EXPECT_EQ(mesh.node(nodeAt(mesh, { 1, 0, 0 })).kind, NodeKind::OnEdge);
  EXPECT_EQ(mesh.node(nodeAt(mesh, { 2, 0, 0 })).kind, NodeKind::Corner);
}

TEST(MeshEditor, HasAnyOfTheseCells)
{
  const MeshEditor hanging = meshOfBoxes(hangingBoxes());
  EXPECT_EQ(faultOf(hanging), "");
  EXPECT_EQ(hanging.facesOf(0).size(), 9);
  EXPECT_EQ(hanging.face(wallOf(hanging, 0, 3)).corners.size, 5); // with the node that hangs
  EXPECT_EQ(volumeOf(hanging), 12);
  const MeshEditor ring = meshOfBoxes(ringOfBoxes());
  EXPECT_EQ(faultOf(ring), "");
  EXPECT_DOUBLE_EQ(volumeBehindWalls(ring), 10);
  EXPECT_EQ(faultOf(wedge()), "");
  EXPECT_EQ(wedge().facesOf(0).size(), 5);
  EXPECT_EQ(volumeOf(wedge()), 0.5);
  EXPECT_EQ(faultOf(dentedCell(0.5)), "");
  EXPECT_EQ(volumeOf(dentedCell(0.5)), 1.5);
  std::vector<TestBox> regions = blockOfBoxes(2, 1, 1);
  regions[1].region = 1;
  const MeshEditor two = meshOfBoxes(regions);
  EXPECT_EQ(faultOf(two), "");
  EXPECT_EQ(two.face(faceBetween(two, 0, 1)).wall, 6);
}

TEST(MeshEditor, MarksNest)
{
  const MeshEditor first = meshOfBoxes(blockOfBoxes(2, 2, 2));
  MeshEditor mesh = copyOf(first);
  const MeshEditor::Mark outer = mesh.mark();
  ASSERT_TRUE(mergeCells(mesh, 0, 1) && updateAndValidate(mesh, ObjectiveSpec()));
  const MeshEditor merged = copyOf(mesh);
  const MeshEditor::Mark inner = mesh.mark();
  mesh.moveNode(nodeAt(mesh, { 1, 1, 1 }), { 1.25, 1, 1 });
  ASSERT_TRUE(updateAndValidate(mesh, ObjectiveSpec()));
  const MeshEditor moved = copyOf(mesh);
  const MeshEditor::Mark innermost = mesh.mark();
  ASSERT_TRUE(mergeCells(mesh, 2, 3) && updateAndValidate(mesh, ObjectiveSpec()));
  mesh.undo(innermost);
  EXPECT_EQ(differenceOf(mesh, moved), "");
  mesh.undo(inner);
  EXPECT_EQ(differenceOf(mesh, merged), "");
  mesh.undo(outer);
  EXPECT_EQ(differenceOf(mesh, first), "");
}

TEST(MeshEditor, WhatIsKeptIsUndoneWithTheOuterMark)
{
  const MeshEditor first = meshOfBoxes(blockOfBoxes(3, 2, 2));
  MeshEditor mesh = copyOf(first);
  const MeshEditor::Mark outer = mesh.mark();
  for (const std::uint32_t c : { 0U, 4U, 8U })
  {
    const MeshEditor::Mark inner = mesh.mark();
    ASSERT_TRUE(mergeCells(mesh, c, c + 1) && updateAndValidate(mesh, ObjectiveSpec()));
    mesh.keep(inner);
    mesh.moveNode(nodeAt(mesh, { 1, 1, 1 }), { 1.25, 1, 1 }); // between the marks
    mesh.moveNode(nodeAt(mesh, { 1.25, 1, 1 }), { 1, 1, 1 });
    ASSERT_TRUE(updateAndValidate(mesh, ObjectiveSpec()));
  }
  EXPECT_EQ(countCells(mesh), 9);
  EXPECT_EQ(faultOf(mesh), "");
  mesh.undo(outer);
  EXPECT_EQ(differenceOf(mesh, first), "");
}

TEST(MeshEditor, RecordsWhatWasAtTheMark)
{
  MeshEditor mesh = meshOfBoxes(blockOfBoxes(2, 1, 1));
  mesh.mark();
  const std::uint32_t n = nodeAt(mesh, { 1, 1, 1 });
  mesh.moveNode(n, { 1, 1, 1.5 });
  mesh.moveNode(n, { 1, 1, 1.25 });
  ASSERT_TRUE(updateAndValidate(mesh, ObjectiveSpec()));
  ASSERT_EQ(mesh.nodeRecords().size(), 1);
  EXPECT_EQ(mesh.nodeRecords()[0].first, n);
  EXPECT_EQ(mesh.nodeRecords()[0].second.at[2], 1);
  EXPECT_EQ(mesh.cellRecords().size(), 2);
  mesh.commit();
  EXPECT_TRUE(mesh.nodeRecords().empty() && mesh.faceRecords().empty());
  EXPECT_EQ(mesh.delta.cost, 0);
  EXPECT_EQ(mesh.node(n).at[2], 1.25);
}

// Any depth of marks, any order of undoing and keeping: each undo gives back what was at its mark.
TEST(MeshEditor, UndoesRandomEditsInAnyNest)
{
  std::mt19937 random(3);
  for (int run = 0; run < 40; ++run)
  {
    MeshEditor mesh = randomMesh(random, 0.2);
    std::vector<std::pair<MeshEditor::Mark, MeshEditor>> marks;
    for (int i = 0; i < 60 && countCells(mesh) > 1; ++i)
    {
      if (marks.size() < 5)
      {
        MeshEditor now = copyOf(mesh);
        marks.emplace_back(mesh.mark(), std::move(now));
      }
      const bool isValid =
        RandomEdits(mesh, random).make(static_cast<int>(random() % RandomEdits::Kinds)) &&
        updateAndValidate(mesh, ObjectiveSpec());
      if (!isValid || random() % 2 == 0)
      {
        mesh.undo(marks.back().first);
        ASSERT_EQ(differenceOf(mesh, marks.back().second), "");
        marks.pop_back();
      }
      else if (random() % 2 == 0)
      {
        mesh.keep(marks.back().first);
        marks.pop_back();
      }
    }
    for (; !marks.empty(); marks.pop_back())
    {
      mesh.undo(marks.back().first);
      ASSERT_EQ(differenceOf(mesh, marks.back().second), "");
    }
  }
}

TEST(CellClosure, IsThatOfOneShell)
{
  MeshEditor one = cellOfTetrahedra(4, { { 0, 1, 2, 3 } });
  EXPECT_TRUE(isClosed(one, 0));
  MeshEditor box = meshOfBoxes(blockOfBoxes(1, 1, 1));
  EXPECT_TRUE(isClosed(box, 0));
  MeshEditor open = copyOf(box);
  open.removeFace(0);
  EXPECT_FALSE(isClosed(open, 0));
}

// Euler's formula holds for all of these.
TEST(CellClosure, IsNoMatterOfNumbersAlone)
{
  MeshEditor touchingInAnEdge = cellOfTetrahedra(6, { { 0, 1, 2, 3 }, { 1, 0, 4, 5 } });
  EXPECT_FALSE(isClosed(touchingInAnEdge, 0));
  MeshEditor touchingInTwoNodes = cellOfTetrahedra(6, { { 0, 1, 2, 3 }, { 0, 4, 5, 3 } });
  EXPECT_FALSE(isClosed(touchingInTwoNodes, 0));
  MeshEditor turned = meshOfBoxes(blockOfBoxes(1, 1, 1));
  const Items ring = turned.cornersOf(0);
  const Numbers reversed(
    std::make_reverse_iterator(ring.end()), std::make_reverse_iterator(ring.begin()));
  turned.setCorners(0, reversed.data(), reversed.size());
  EXPECT_FALSE(isClosed(turned, 0));
}

TEST(CellClosure, IsNotThatOfARing)
{
  MeshEditor ring = meshOfBoxes(ringOfBoxes());
  for (std::uint32_t c = 1; c < 9; ++c)
  {
    ASSERT_TRUE(mergeCells(ring, 0, c));
    EXPECT_TRUE(isClosed(ring, 0)) << c;
  }
  ring.commit();
  ASSERT_TRUE(mergeCells(ring, 0, 9));
  EXPECT_FALSE(isClosed(ring, 0));
  EXPECT_FALSE(updateAndValidate(ring, ObjectiveSpec()));
}

// A cell that was a ring before may stay one. Cut across, it is none, and may not become one again.
TEST(CellClosure, IsThatOfARingThatWasOne)
{
  MeshEditor ring = meshOfBoxes(ringOfBoxes());
  for (std::uint32_t c = 1; c < 10; ++c)
  {
    ASSERT_TRUE(mergeCells(ring, 0, c));
  }
  ring.commit();
  Execution execution(1);
  noteEulerDefects(ring.mesh(), execution);
  EXPECT_EQ(ring.cell(0).eulerDefect, 2);
  EXPECT_TRUE(isClosed(ring, 0));
  measureAll(ring.mesh(), execution);
  CutParts parts;
  const Vector centre = ring.cell(0).centre;
  ASSERT_TRUE(cutCell(ring, 0, { centre, { 1, 0, 0 }, 0.01 }, parts));
  ASSERT_TRUE(updateAndValidate(ring, ObjectiveSpec()));
  for (const std::uint32_t part : parts)
  {
    EXPECT_EQ(ring.cell(part).eulerDefect, 0);
    EXPECT_TRUE(isClosed(ring, part));
  }
}

}
