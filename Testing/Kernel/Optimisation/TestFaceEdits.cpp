// SPDX-License-Identifier: BSD-3-Clause
// Edits of faces, on two boxes side by side whose common side is divided into two faces.
#include "Optimisation/FaceEdits.h"

#include <gtest/gtest.h>

namespace cartesian
{

namespace
{

using Numbers = std::vector<std::uint32_t>;

// Nodes 0 to 3 on the left, 4 to 7 on the common side, 8 to 11 on the right; 12 and 13 halfway up the common side.
//
//      3--------7--------11      each at y = 0; y = 1: one more: 1, 5, 9, 13 below, 2, 6, 10 above
//      |        13       |
//      0--------4--------8
NodeMesh twoBoxes()
{
  NodeMesh mesh;
  for (const double x : { 0.0, 1.0, 2.0 })
  {
    for (const auto& [y, z] : { std::pair{ 0.0, 0.0 }, { 1.0, 0.0 }, { 1.0, 1.0 }, { 0.0, 1.0 } })
    {
      mesh.nodes.at.push_back({ x, y, z });
    }
  }
  mesh.nodes.at.push_back({ 1, 0, 0.5 });
  mesh.nodes.at.push_back({ 1, 1, 0.5 });
  for (std::uint32_t n = 0; n < mesh.nodes.at.size(); ++n)
  {
    mesh.nodes.number.push_back(100 + n);
    mesh.nodes.mayMove.push_back(1);
  }
  const auto add = [&](const Numbers& ring, std::uint32_t below, std::uint32_t above) {
    mesh.faces.corners.insert(mesh.faces.corners.end(), ring.begin(), ring.end());
    mesh.faces.close({ below, above }, above == None ? 0 : NoBoundary,
      static_cast<std::uint32_t>(10 + mesh.faces.size()));
  };
  add({ 4, 5, 13, 12 }, 0, 1);
  add({ 12, 13, 6, 7 }, 0, 1);
  add({ 0, 3, 2, 1 }, 0, None);
  add({ 8, 9, 10, 11 }, 1, None);
  for (const std::uint32_t cell : { 0U, 1U })
  {
    const std::uint32_t n = 4 * cell;
    add({ n, n + 1, n + 5, n + 4 }, cell, None);
    add({ n + 3, n + 7, n + 6, n + 2 }, cell, None);
    add(cell == 0 ? Numbers{ 0, 4, 12, 7, 3 } : Numbers{ 4, 8, 11, 7, 12 }, cell, None);
    add(cell == 0 ? Numbers{ 1, 2, 6, 13, 5 } : Numbers{ 5, 13, 6, 10, 9 }, cell, None);
  }
  mesh.cells.changing = 2;
  for (const std::uint32_t cell : { 0U, 1U })
  {
    mesh.cells.number.push_back(cell);
    mesh.cells.box.push_back(None);
    mesh.cells.region.push_back(0);
    mesh.cells.volumeOfBox.push_back(1);
    mesh.cells.measures.emplace_back();
    mesh.cells.firstUse.push_back(static_cast<std::uint32_t>(mesh.cells.uses.size()));
    for (std::uint32_t f = 0; f < mesh.faces.size(); ++f)
    {
      if (mesh.faces.cells[f][0] == cell || mesh.faces.cells[f][1] == cell)
      {
        mesh.cells.uses.push_back(f);
      }
    }
    mesh.cells.endUse.push_back(static_cast<std::uint32_t>(mesh.cells.uses.size()));
  }
  return mesh;
}

Numbers ringOf(const NodeMesh& mesh, std::uint32_t f)
{
  Numbers ring;
  mesh.forEachCorner(f, [&](std::uint32_t n) { ring.push_back(n); });
  return ring;
}

Numbers numbers(const NumberLists::List& list)
{
  return { list.begin(), list.end() };
}

struct Edited
{
  Surroundings around(const Numbers& faces) const
  {
    Surroundings surroundings{ faces, {}, {} };
    edits.lookAround(surroundings);
    return surroundings;
  }

  NodeMesh mesh = twoBoxes();
  FaceEdits edits{ mesh };
};

}

TEST(FaceEdits, LooksAroundFaces)
{
  const Edited of;
  EXPECT_EQ(numbers(of.edits.facesOf(12)), (Numbers{ 0, 1, 6, 10 }));
  EXPECT_EQ(of.around({ 2 }).cells, (Numbers{ 0 }));
  EXPECT_EQ(of.around({ 2 }).facesOfCells, (Numbers{ 0, 1, 2, 4, 5, 6, 7 }));
  EXPECT_EQ(of.around({ 0 }).cells, (Numbers{ 0, 1 }));
  EXPECT_TRUE(of.edits.areBetweenTheSame(0, 1));
  EXPECT_FALSE(of.edits.areBetweenTheSame(0, 2));
  EXPECT_TRUE(of.edits.mayChange(0));
}

TEST(FaceEdits, JoinsFacesBetweenTheSameCells)
{
  Edited of;
  ASSERT_TRUE(of.edits.join(0, 1, of.around({ 0, 1 })));
  EXPECT_EQ(of.edits.remaining(), (Numbers{ 0 }));
  EXPECT_TRUE(of.edits.isSound());
  of.edits.commit();
  EXPECT_TRUE(of.edits.isGone(1));
  EXPECT_EQ(ringOf(of.mesh, 0), (Numbers{ 12, 4, 5, 13, 6, 7 }));
  EXPECT_EQ(numbers(of.edits.facesOf(6)), (Numbers{ 0, 5, 7, 9, 11 }));
  EXPECT_EQ(of.around({ 0 }).facesOfCells.size(), 11U);
  const std::vector<FaceEdit> edits = of.edits.edits();
  ASSERT_EQ(edits.size(), 2U);
  EXPECT_EQ(edits[0].face, 10U);
  EXPECT_EQ(edits[0].ring, (Numbers{ 112, 104, 105, 113, 106, 107 }));
  EXPECT_EQ(edits[1].face, 11U);
  EXPECT_TRUE(edits[1].ring.empty());
}

TEST(FaceEdits, CollapsesNodesUntilAFaceVanishes)
{
  Edited of;
  ASSERT_TRUE(of.edits.collapse(12, 4, of.around(numbers(of.edits.facesOf(12)))));
  EXPECT_TRUE(of.edits.isSound());
  of.edits.commit();
  EXPECT_EQ(ringOf(of.mesh, 0), (Numbers{ 4, 5, 13 }));
  EXPECT_EQ(ringOf(of.mesh, 6), (Numbers{ 0, 4, 7, 3 }));
  EXPECT_TRUE(of.edits.facesOf(12).empty());
  EXPECT_TRUE(of.edits.hasCorner(1, 4));
  ASSERT_TRUE(of.edits.collapse(13, 5, of.around(numbers(of.edits.facesOf(13)))));
  EXPECT_TRUE(of.edits.isSound());
  of.edits.commit();
  EXPECT_TRUE(of.edits.isGone(0));
  EXPECT_EQ(ringOf(of.mesh, 1), (Numbers{ 4, 5, 6, 7 }));
  EXPECT_EQ(of.mesh.cells.endUse[0] - of.mesh.cells.firstUse[0], 6U);
}

TEST(FaceEdits, PutsBackAllThatItTries)
{
  Edited of;
  const NodeMesh before = twoBoxes();
  const auto expectAsBefore = [&] {
    for (std::uint32_t f = 0; f < before.faces.size(); ++f)
    {
      EXPECT_EQ(ringOf(of.mesh, f), ringOf(before, f));
      EXPECT_FALSE(of.edits.isGone(f));
    }
    EXPECT_EQ(of.mesh.cells.uses, before.cells.uses);
    EXPECT_EQ(of.mesh.cells.endUse, before.cells.endUse);
    EXPECT_EQ(of.mesh.faces.corners.size(), before.faces.corners.size());
  };
  of.edits.join(0, 1, of.around({ 0, 1 }));
  of.edits.putBack();
  expectAsBefore();
  of.edits.collapse(12, 4, of.around(numbers(of.edits.facesOf(12))));
  of.edits.putBack();
  expectAsBefore();
  EXPECT_TRUE(of.edits.edits().empty());
}

TEST(FaceEdits, RefusesWhatIsNoMesh)
{
  Edited of;
  EXPECT_FALSE(of.edits.join(4, 5, of.around({ 4, 5 }))) << "no common edge";
  of.edits.putBack();
}

// Two nodes of a face that are no neighbours pinch it.
TEST(FaceEdits, RefusesFacesThatMeetThemselves)
{
  Edited of;
  ASSERT_TRUE(of.edits.join(2, 6, of.around({ 2, 6 }))); // around the edge from 0 to 3
  of.edits.commit();
  EXPECT_EQ(ringOf(of.mesh, 2).size(), 7U);
  EXPECT_FALSE(of.edits.collapse(12, 1, of.around(numbers(of.edits.facesOf(12)))));
  of.edits.putBack();
}

// Above and below the left box would be the same face.
TEST(FaceEdits, RefusesCellsWithoutThickness)
{
  Edited of;
  bool isMesh = true;
  for (const auto& [from, into] :
    { std::pair{ 12U, 4U }, { 13U, 5U }, { 7U, 4U }, { 6U, 5U }, { 3U, 0U }, { 2U, 1U } })
  {
    isMesh = isMesh && of.edits.collapse(from, into, of.around(numbers(of.edits.facesOf(from)))) &&
      of.edits.isSound();
    of.edits.commit();
  }
  EXPECT_FALSE(isMesh);
}

}
