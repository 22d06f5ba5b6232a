// Cells that touch themselves along an edge are closed where they may be.
#include "Editing/CellClosure.h"
#include "Editing/EditDecision.h"
#include "Support/EditMeshes.h"

#include <gtest/gtest.h>

namespace cartesian
{

namespace
{

TestBox boxAt(int x, int y, int z)
{
  return { { x, y, z }, { x + 1, y + 1, z + 1 } };
}

// Two boxes that touch along an edge, on three that connect them.
std::vector<TestBox> touchingBoxes()
{
  return { boxAt(0, 0, 0), boxAt(1, 0, 0), boxAt(1, 1, 0), boxAt(0, 0, 1), boxAt(1, 1, 1) };
}

}

TEST(CellClosure, ACellThatTouchesItselfIsClosedWhereItMayBe)
{
  MeshEditor mesh = cellOfBoxes(touchingBoxes());
  ASSERT_EQ(countCells(mesh), 1);
  EXPECT_TRUE(touchesItself(mesh, 0));
  EXPECT_FALSE(isClosed(mesh, 0));
  mesh.rawCell(0).touches = true;
  mesh.rawCell(0).eulerDefect = 4;
  EXPECT_TRUE(isClosed(mesh, 0));
}

TEST(CellClosure, ACellThatStopsTouchingItselfMayNotBegin)
{
  MeshEditor mesh = meshOfBoxes(touchingBoxes());
  EXPECT_FALSE(touchesItself(mesh, 0));
  mesh.rawCell(0).touches = true;
  lowerMisses(mesh, 0);
  EXPECT_FALSE(mesh.cell(0).touches);
}

TEST(CellClosure, AnOpenCellIsNotClosedHoweverItTouchesItself)
{
  MeshEditor mesh = cellOfBoxes(touchingBoxes());
  mesh.rawCell(0).touches = true;
  mesh.rawCell(0).eulerDefect = 4;
  const std::uint32_t wall = mesh.facesOf(0)[0];
  mesh.removeFace(wall);
  EXPECT_FALSE(isClosed(mesh, 0));
}

}
