// Each primitive edit, on meshes made by hand: what it makes, and that it is undone to the last bit.
#include "Editing/CellCut.h"
#include "Editing/EditDecision.h"
#include "Editing/PrimitiveEdits.h"
#include "Support/EditMeshes.h"

#include <gtest/gtest.h>

namespace cartesian
{

namespace
{

using Edit = std::function<bool(MeshEditor&)>;

// Made, undone, made again, within another mark too; leaves it made. Whether it could be.
bool makeAndUndo(MeshEditor& mesh, const Edit& edit)
{
  const MeshEditor before = copyOf(mesh);
  const MeshEditor::Mark mark = mesh.mark();
  const bool isMade = edit(mesh) && updateAndValidate(mesh, ObjectiveSpec());
  const MeshEditor after = copyOf(mesh);
  mesh.undo(mark);
  EXPECT_EQ(differenceOf(mesh, before), "");
  EXPECT_EQ(mesh.dirty.faces.size() + mesh.dirty.cells.size(), 0);
  if (!isMade)
  {
    return false;
  }
  const MeshEditor::Mark outer = mesh.mark();
  const MeshEditor::Mark inner = mesh.mark();
  EXPECT_TRUE(edit(mesh) && updateAndValidate(mesh, ObjectiveSpec()));
  mesh.undo(inner);
  EXPECT_EQ(differenceOf(mesh, before), "");
  const MeshEditor::Mark second = mesh.mark();
  EXPECT_TRUE(edit(mesh) && updateAndValidate(mesh, ObjectiveSpec()));
  EXPECT_EQ(differenceOf(mesh, after), "");
  mesh.keep(second);
  mesh.undo(outer);
  EXPECT_EQ(differenceOf(mesh, before), "");
  EXPECT_TRUE(edit(mesh) && updateAndValidate(mesh, ObjectiveSpec()));
  EXPECT_EQ(differenceOf(mesh, after), "");
  mesh.commit();
  EXPECT_EQ(faultOf(mesh), "");
  EXPECT_NEAR(volumeOf(mesh), volumeBehindWalls(mesh), 1e-13);
  return true;
}

MeshEditor block(int x, int y, int z)
{
  return meshOfBoxes(blockOfBoxes(x, y, z));
}

// Of two boxes side by side along x, in regions.
MeshEditor twoRegions()
{
  std::vector<TestBox> boxes = blockOfBoxes(2, 1, 1);
  boxes[1].region = 1;
  return meshOfBoxes(boxes);
}

bool collapseAt(MeshEditor& mesh, const Vector& from, const Vector& to)
{
  return collapseEdge(mesh, nodeAt(mesh, from), nodeAt(mesh, to), to);
}

}

TEST(CollapseEdge, TakesACornerOffEachFace)
{
  MeshEditor mesh = block(2, 2, 2);
  const std::size_t faces = countFaces(mesh);
  ASSERT_TRUE(makeAndUndo(mesh, [](MeshEditor& m) {
    return collapseAt(m, { 1, 1, 1 }, { 1, 1, 2 });
  }));
  EXPECT_EQ(nodeAt(mesh, { 1, 1, 1 }), None);
  EXPECT_EQ(countFaces(mesh), faces);
  EXPECT_EQ(volumeBehindWalls(mesh), 8);
}

TEST(CollapseEdge, MovesTheNodeThatStays)
{
  MeshEditor mesh = block(2, 2, 2);
  const std::uint32_t v = nodeAt(mesh, { 1, 1, 2 });
  ASSERT_TRUE(makeAndUndo(mesh, [&](MeshEditor& m) {
    return collapseEdge(m, nodeAt(m, { 1, 1, 1 }), v, { 1, 1, 1.75 });
  }));
  EXPECT_EQ(mesh.node(v).at[2], 1.75);
  EXPECT_LT(volumeBehindWalls(mesh), 8);
}

// A triangle on the outside goes with its edge; the square beside it is bent, between 1/6 and 1/3.
TEST(CollapseEdge, TakesTrianglesAway)
{
  MeshEditor mesh = wedge();
  ASSERT_TRUE(makeAndUndo(mesh, [](MeshEditor& m) {
    return collapseAt(m, { 1, 0, 1 }, { 1, 0, 0 });
  }));
  EXPECT_EQ(mesh.facesOf(0).size(), 4);
  EXPECT_DOUBLE_EQ(volumeOf(mesh), 0.25);
}

TEST(CollapseEdge, RefusesWhatIsNoEdgeOfAFace)
{
  MeshEditor mesh = block(1, 1, 1);
  EXPECT_FALSE(makeAndUndo(mesh, [](MeshEditor& m) {
    return collapseAt(m, { 0, 0, 0 }, { 1, 1, 0 });
  }));
  EXPECT_FALSE(makeAndUndo(mesh, [](MeshEditor& m) {
    return collapseAt(m, { 0, 0, 0 }, { 0, 0, 0 });
  }));
  EXPECT_FALSE(makeAndUndo(mesh, [](MeshEditor& m) { // through the cell
    return collapseAt(m, { 0, 0, 0 }, { 1, 1, 1 });
  }));
}

// All edges of a box along x: what was beyond meets.
TEST(CollapseEdge, TakesFlatCellsAway)
{
  MeshEditor mesh = block(3, 1, 1);
  const MeshEditor before = copyOf(mesh);
  ASSERT_TRUE(makeAndUndo(mesh, [](MeshEditor& m) {
    return collapseAt(m, { 1, 0, 0 }, { 2, 0, 0 }) && collapseAt(m, { 1, 1, 0 }, { 2, 1, 0 }) &&
      collapseAt(m, { 1, 0, 1 }, { 2, 0, 1 }) && collapseAt(m, { 1, 1, 1 }, { 2, 1, 1 });
  }));
  EXPECT_EQ(countCells(mesh), 2);
  EXPECT_EQ(countFaces(mesh), 11);
  EXPECT_NE(faceBetween(mesh, 0, 2), None);
  EXPECT_DOUBLE_EQ(mesh.cell(0).volume, 2);
}

// ... and the wall, where there is nothing.
TEST(CollapseEdge, LeavesTheWallWhereAFlatCellWas)
{
  for (const bool isFirst : { true, false })
  {
    MeshEditor mesh = block(2, 1, 1);
    const double to = isFirst ? 1 : 2;
    const double from = isFirst ? 0 : 1;
    ASSERT_TRUE(makeAndUndo(mesh, [&](MeshEditor& m) {
      return collapseAt(m, { from, 0, 0 }, { to, 0, 0 }) &&
        collapseAt(m, { from, 1, 0 }, { to, 1, 0 }) &&
        collapseAt(m, { from, 0, 1 }, { to, 0, 1 }) && collapseAt(m, { from, 1, 1 }, { to, 1, 1 });
    }));
    EXPECT_EQ(countCells(mesh), 1);
    const std::uint32_t wall = wallOf(mesh, isFirst ? 1 : 0, isFirst ? 0 : 1);
    ASSERT_NE(wall, None);
    EXPECT_EQ(norm(mesh.face(wall).original), 1);
    EXPECT_EQ(volumeBehindWalls(mesh), isFirst ? 1 : 2);
  }
}

// The border between regions is where the cell was, whichever side of it goes.
TEST(CollapseEdge, LeavesTheBorderWhereAFlatCellWas)
{
  for (const std::int32_t middle : { 0, 1 })
  {
    std::vector<TestBox> boxes = blockOfBoxes(3, 1, 1);
    boxes[1].region = middle;
    boxes[2].region = 1;
    MeshEditor mesh = meshOfBoxes(boxes);
    ASSERT_TRUE(makeAndUndo(mesh, [](MeshEditor& m) {
      return collapseAt(m, { 1, 0, 0 }, { 2, 0, 0 }) && collapseAt(m, { 1, 1, 0 }, { 2, 1, 0 }) &&
        collapseAt(m, { 1, 0, 1 }, { 2, 0, 1 }) && collapseAt(m, { 1, 1, 1 }, { 2, 1, 1 });
    }));
    EXPECT_EQ(mesh.face(faceBetween(mesh, 0, 2)).wall, 6);
  }
}

// Between two parts of another one it would be gone: these would be one.
TEST(CollapseEdge, EndsNoRegion)
{
  std::vector<TestBox> boxes = blockOfBoxes(3, 1, 1);
  boxes[1].region = 1;
  MeshEditor mesh = meshOfBoxes(boxes);
  EXPECT_FALSE(makeAndUndo(mesh, [](MeshEditor& m) {
    return collapseAt(m, { 1, 0, 0 }, { 2, 0, 0 }) && collapseAt(m, { 1, 1, 0 }, { 2, 1, 0 }) &&
      collapseAt(m, { 1, 0, 1 }, { 2, 0, 1 }) && collapseAt(m, { 1, 1, 1 }, { 2, 1, 1 });
  }));
}

TEST(SplitFace, IsUndoneByJoining)
{
  MeshEditor mesh = block(2, 1, 1);
  const std::uint32_t f = faceBetween(mesh, 0, 1);
  const std::size_t faces = countFaces(mesh);
  std::uint32_t made = None;
  ASSERT_TRUE(makeAndUndo(mesh, [&](MeshEditor& m) {
    made = splitFace(m, f, 0, 2);
    return made != None;
  }));
  EXPECT_EQ(countFaces(mesh), faces + 1);
  EXPECT_EQ(mesh.cornersOf(f).size(), 3);
  EXPECT_EQ(norm(mesh.face(f).area), 0.5);
  ASSERT_TRUE(makeAndUndo(mesh, [&](MeshEditor& m) { return joinFaces(m, f, made); }));
  EXPECT_EQ(countFaces(mesh), faces);
  EXPECT_EQ(mesh.cornersOf(f).size(), 4);
  EXPECT_EQ(norm(mesh.face(f).area), 1);
}

TEST(SplitFace, RefusesNeighbouringCorners)
{
  MeshEditor mesh = block(1, 1, 1);
  EXPECT_FALSE(makeAndUndo(mesh, [](MeshEditor& m) { return splitFace(m, 0, 1, 2) != None; }));
  EXPECT_FALSE(makeAndUndo(mesh, [](MeshEditor& m) { return splitFace(m, 0, 3, 0) != None; }));
  EXPECT_FALSE(makeAndUndo(mesh, [](MeshEditor& m) { return splitFace(m, 0, 1, 1) != None; }));
}

TEST(SplitFace, DividesItsDeficit)
{
  MeshEditor mesh = block(1, 1, 1);
  mesh.rawFace(0).volumeDeficit = 0.5;
  std::uint32_t made = None;
  ASSERT_TRUE(makeAndUndo(mesh, [&](MeshEditor& m) {
    made = splitFace(m, 0, 0, 2);
    return made != None;
  }));
  EXPECT_EQ(mesh.face(0).volumeDeficit + mesh.face(made).volumeDeficit, 0.5);
  EXPECT_TRUE(mesh.isWall(made));
}

// The four faces between a large box and small ones stay apart; walls of one box at an angle may be joined here.
TEST(JoinFaces, NeedsOnePairOfCellsAndOneWall)
{
  MeshEditor mesh = meshOfBoxes(hangingBoxes());
  EXPECT_FALSE(makeAndUndo(
    mesh, [](MeshEditor& m) { return joinFaces(m, faceBetween(m, 0, 1), faceBetween(m, 0, 2)); }));
  EXPECT_FALSE(makeAndUndo(mesh, [](MeshEditor& m) { // of different walls
    return joinFaces(m, wallOf(m, 0, 0), wallOf(m, 0, 2));
  }));
  mesh.rawFace(wallOf(mesh, 0, 2)).wall = 0;
  ASSERT_TRUE(makeAndUndo(mesh, [](MeshEditor& m) {
    const Items faces = m.facesOf(0);
    std::vector<std::uint32_t> walls;
    std::copy_if(faces.begin(), faces.end(), std::back_inserter(walls),
      [&](std::uint32_t f) { return m.face(f).wall == 0; });
    return walls.size() == 2 && joinFaces(m, walls[0], walls[1]);
  }));
}

// The node between both sides goes with the edges that they share.
TEST(JoinFaces, TakesNodesBetweenAway)
{
  MeshEditor mesh = meshOfBoxes(hangingBoxes());
  for (const auto& [a, b] : { std::pair{ 1U, 2U }, { 1U, 3U }, { 1U, 4U } })
  {
    ASSERT_TRUE(makeAndUndo(mesh, [a = a, b = b](MeshEditor& m) { return mergeCells(m, a, b); }));
  }
  // Between the two: four faces, joined one by one.
  for (int i = 0; i < 3; ++i)
  {
    ASSERT_TRUE(makeAndUndo(mesh,
      [](MeshEditor& m) {
        const std::uint32_t f = faceBetween(m, 0, 1);
        for (const std::uint32_t g : m.facesOf(0))
        {
          const MeshEditor::Mark mark = m.mark();
          if (m.beyond(g, 0) == 1 && joinFaces(m, f, g))
          {
            m.keep(mark);
            return true;
          }
          m.undo(mark);
        }
        return false;
      }))
      << i;
  }
  EXPECT_EQ(norm(mesh.face(faceBetween(mesh, 0, 1)).area), 4);
  EXPECT_EQ(nodeAt(mesh, { 2, 1, 1 }), None);
}

TEST(PassFace, GivesAWallToTheNeighbour)
{
  MeshEditor mesh = block(2, 1, 1);
  const std::uint32_t between = faceBetween(mesh, 0, 1);
  const std::uint32_t top = wallOf(mesh, 0, 5);
  ASSERT_TRUE(makeAndUndo(mesh, [&](MeshEditor& m) { return passFace(m, 0, between, top); }));
  EXPECT_EQ(mesh.face(top).below, 1);
  EXPECT_EQ(mesh.facesOf(0).size(), 5);
  EXPECT_EQ(mesh.facesOf(1).size(), 7);
  EXPECT_EQ(mesh.face(between).corners.size, 6);
  EXPECT_NEAR(volumeBehindWalls(mesh), 2, 1e-15);
}

TEST(PassFace, RefusesFacesApartAndOtherRegions)
{
  MeshEditor mesh = block(2, 1, 1);
  const MeshEditor::Mark mark = mesh.mark();
  EXPECT_FALSE(passFace(mesh, 0, faceBetween(mesh, 0, 1), wallOf(mesh, 0, 0))); // opposite
  EXPECT_FALSE(passFace(mesh, 0, wallOf(mesh, 0, 0), wallOf(mesh, 0, 5)));      // over a wall
  mesh.undo(mark);
  MeshEditor regions = twoRegions();
  const MeshEditor::Mark other = regions.mark();
  EXPECT_FALSE(passFace(regions, 0, faceBetween(regions, 0, 1), wallOf(regions, 0, 5)));
  regions.undo(other);
}

TEST(MergeCells, TakesTheFacesBetweenThem)
{
  MeshEditor mesh = block(2, 2, 2);
  ASSERT_TRUE(makeAndUndo(mesh, [](MeshEditor& m) { return mergeCells(m, 0, 1); }));
  EXPECT_EQ(countCells(mesh), 7);
  EXPECT_DOUBLE_EQ(mesh.cell(0).volume, 2);
  EXPECT_EQ(mesh.facesOf(0).size(), 10);
  EXPECT_EQ(volumeBehindWalls(mesh), 8);
}

TEST(MergeCells, RefusesCellsThatAreNoNeighboursAndOtherRegions)
{
  MeshEditor mesh = block(3, 1, 1);
  EXPECT_FALSE(makeAndUndo(mesh, [](MeshEditor& m) { return mergeCells(m, 0, 2); }));
  EXPECT_FALSE(makeAndUndo(mesh, [](MeshEditor& m) { return mergeCells(m, 1, 1); }));
  MeshEditor regions = twoRegions();
  EXPECT_FALSE(makeAndUndo(regions, [](MeshEditor& m) { return mergeCells(m, 0, 1); }));
}

TEST(MergeCells, MayNotCloseARing)
{
  MeshEditor mesh = meshOfBoxes(ringOfBoxes());
  for (std::uint32_t c = 1; c < 9; ++c)
  {
    ASSERT_TRUE(makeAndUndo(mesh, [&](MeshEditor& m) { return mergeCells(m, 0, c); }));
  }
  EXPECT_FALSE(makeAndUndo(mesh, [](MeshEditor& m) { return mergeCells(m, 0, 9); }));
}

TEST(RemoveCell, MakesWallsOfItsNeighbours)
{
  MeshEditor mesh = block(3, 3, 3);
  const std::uint32_t corner = 0;
  ASSERT_TRUE(makeAndUndo(mesh, [&](MeshEditor& m) { return removeCell(m, corner); }));
  EXPECT_EQ(countCells(mesh), 26);
  EXPECT_NEAR(volumeBehindWalls(mesh), 26, 1e-13);
  const EditNode& inside = mesh.node(nodeAt(mesh, { 1, 1, 1 }));
  EXPECT_TRUE(inside.atWall);
  EXPECT_EQ(inside.kind, NodeKind::OnSurface);
  EXPECT_EQ(inside.referencePosition, inside.at);
}

TEST(RemoveCell, InTheMiddleLeavesAHole)
{
  MeshEditor mesh = block(3, 3, 3);
  ASSERT_TRUE(makeAndUndo(mesh, [](MeshEditor& m) { return removeCell(m, 13); }));
  EXPECT_NEAR(volumeBehindWalls(mesh), 26, 1e-13);
}

// The other region would end there, and nothing pass from one into the other.
TEST(RemoveCell, IsNotForCellsAtAnotherRegion)
{
  MeshEditor mesh = twoRegions();
  for (const std::uint32_t gone : { 0U, 1U })
  {
    EXPECT_FALSE(makeAndUndo(mesh, [&](MeshEditor& m) { return removeCell(m, gone); }));
  }
}

TEST(MoveNode, UnsettlesItsFaces)
{
  MeshEditor mesh = block(2, 2, 2);
  ASSERT_TRUE(makeAndUndo(mesh, [](MeshEditor& m) {
    m.moveNode(nodeAt(m, { 1, 1, 1 }), { 1.25, 0.75, 1.25 });
    return m.dirty.faces.size() == 12;
  }));
  EXPECT_NEAR(volumeOf(mesh), 8, 1e-14);
}

TEST(MoveNode, MayNotTurnACellInsideOut)
{
  MeshEditor mesh = block(1, 1, 1);
  EXPECT_FALSE(makeAndUndo(mesh, [](MeshEditor& m) {
    for (const double x : { 0.0, 1.0 })
    {
      for (const double y : { 0.0, 1.0 })
      {
        m.moveNode(nodeAt(m, { x, y, 1 }), { x, y, -1 });
      }
    }
    return true;
  }));
}

// Nothing of a ghost changes, or of a cell that no editor has.
TEST(PrimitiveEdits, StayWithinFreeCells)
{
  for (const bool isGhost : { false, true })
  {
    MeshEditor mesh = block(3, 1, 1);
    mesh.rawCell(1).state = isGhost ? CellState::Ghost : CellState::Free;
    mesh.rawCell(1).zone = isGhost ? 0 : None;
    const std::vector<Edit> edits{ [](MeshEditor& m) {
                                    return collapseAt(m, { 1, 0, 0 }, { 0, 0, 0 });
                                  },
      [](MeshEditor& m) {
        return collapseAt(m, { 0, 0, 0 }, { 1, 0, 0 }) &&
          (m.moveNode(nodeAt(m, { 1, 0, 0 }), { 1.25, 0, 0 }), true);
      },
      [](MeshEditor& m) { return splitFace(m, faceBetween(m, 0, 1), 0, 2) != None; },
      [](MeshEditor& m) { return mergeCells(m, 0, 1); },
      [](MeshEditor& m) { return mergeCells(m, 1, 0); },
      [](MeshEditor& m) { return removeCell(m, 0); },
      [](MeshEditor& m) { return removeCell(m, 1); },
      [](MeshEditor& m) {
        CutParts parts;
        return cutCell(m, 1, { { 1.5, 0.5, 0.5 }, { 1, 0, 0 }, 0.01 }, parts);
      },
      [](MeshEditor& m) {
        CutParts parts; // through edges that the other has too
        return cutCell(m, 0, { { 1, 0.5, 0.5 }, unit({ 1, 1, 0 }), 0.01 }, parts);
      },
      [](MeshEditor& m) {
        m.moveNode(nodeAt(m, { 1, 0, 0 }), { 1, 0, 0.25 });
        return true;
      } };
    for (std::size_t i = 0; i < edits.size(); ++i)
    {
      EXPECT_FALSE(makeAndUndo(mesh, edits[i])) << i;
    }
    EXPECT_TRUE(makeAndUndo(mesh, [](MeshEditor& m) {
      return collapseAt(m, { 0, 0, 0 }, { 1, 0, 0 });
    }));
  }
}

TEST(OnLattice, IsOnOddLevelsButWhereHeld)
{
  MeshEditor mesh;
  mesh.mesh().level = 0.25;
  EXPECT_EQ(onLattice(mesh, { 1, 1.2, -0.1 }, 0), (Vector{ 1.25, 1.25, -0.25 }));
  EXPECT_EQ(onLattice(mesh, { 1, 1.2, -0.1 }, 5), (Vector{ 1, 1.25, -0.1 }));
  EXPECT_EQ(onLattice(mesh, { 1, 1.2, -0.1 }, AllAxes), (Vector{ 1, 1.2, -0.1 }));
}

}
