// Cuts of cells by planes: of cubes in all positions, of cells with several sections, and those that are refused.
#include "Editing/CellCut.h"
#include "Editing/EditDecision.h"
#include "Support/EditMeshes.h"

#include <gtest/gtest.h>

namespace cartesian
{

namespace
{

constexpr double Tolerance = 0.03;

// Cuts, tests the mesh, and returns the number of parts: 0, the mesh as it was, where that is refused.
std::size_t cut(
  MeshEditor& mesh, std::uint32_t c, const Vector& through, const Vector& normal, CutParts& parts)
{
  const MeshEditor before = copyOf(mesh);
  const double volume = volumeOf(mesh, c);
  const MeshEditor::Mark mark = mesh.mark();
  parts.clear();
  if (!cutCell(mesh, c, { through, unit(normal), Tolerance }, parts) ||
    !updateAndValidate(mesh, ObjectiveSpec()))
  {
    mesh.undo(mark);
    EXPECT_EQ(differenceOf(mesh, before), "");
    return 0;
  }
  mesh.commit();
  EXPECT_EQ(faultOf(mesh), "");
  EXPECT_EQ(countCells(mesh), countCells(before) + parts.size() - 1);
  EXPECT_EQ(parts[0], c);
  double sum = 0;
  for (const std::uint32_t part : parts)
  {
    sum += volumeOf(mesh, part);
  }
  EXPECT_NEAR(sum, volume, 1e-12);
  EXPECT_NEAR(volumeBehindWalls(mesh), volumeBehindWalls(before), 1e-12);
  return parts.size();
}

std::size_t cut(MeshEditor& mesh, std::uint32_t c, const Vector& through, const Vector& normal)
{
  CutParts parts;
  return cut(mesh, c, through, normal, parts);
}

// Sorted.
std::vector<double> volumesOf(const MeshEditor& mesh, const CutParts& parts)
{
  std::vector<double> volumes;
  for (const std::uint32_t part : parts)
  {
    volumes.push_back(mesh.cell(part).volume);
  }
  std::sort(volumes.begin(), volumes.end());
  return volumes;
}

void expectVolumes(const MeshEditor& mesh, const CutParts& parts, const std::vector<double>& wanted)
{
  const std::vector<double> volumes = volumesOf(mesh, parts);
  ASSERT_EQ(volumes.size(), wanted.size());
  for (std::size_t i = 0; i < wanted.size(); ++i)
  {
    EXPECT_NEAR(volumes[i], wanted[i], 1e-12);
  }
}

MeshEditor cube()
{
  return meshOfBoxes(blockOfBoxes(1, 1, 1));
}

// The corners of the face between two parts.
std::size_t cornersBetween(const MeshEditor& mesh, const CutParts& parts)
{
  return mesh.face(faceBetween(mesh, parts[0], parts[1])).corners.size;
}

}

TEST(CellCut, ThroughTheMiddle)
{
  for (const std::size_t axis : { 0, 1, 2 })
  {
    for (const double way : { 1.0, -1.0 })
    {
      MeshEditor mesh = cube();
      CutParts parts;
      Vector normal{};
      normal[axis] = way;
      ASSERT_EQ(cut(mesh, 0, { 0.5, 0.5, 0.5 }, normal, parts), 2);
      EXPECT_EQ(cornersBetween(mesh, parts), 4);
      EXPECT_NEAR(mesh.cell(0).volume, 0.5, 1e-12);
      EXPECT_EQ(mesh.facesOf(0).size(), 6);
      EXPECT_EQ(mesh.facesOf(parts[1]).size(), 6);
    }
  }
}

TEST(CellCut, ThroughEdges)
{
  MeshEditor mesh = cube();
  CutParts parts;
  ASSERT_EQ(cut(mesh, 0, { 0.5, 0.5, 0.5 }, { 1, 1, 0 }, parts), 2);
  expectVolumes(mesh, parts, { 0.5, 0.5 });
  EXPECT_EQ(mesh.nodeCount(), 8);
}

TEST(CellCut, ThroughCorners)
{
  MeshEditor mesh = cube();
  CutParts parts;
  ASSERT_EQ(
    cut(mesh, 0, { 1, 0, 0 }, { 1, 1, 1 }, parts), 2); // off one corner, through three others
  EXPECT_EQ(cornersBetween(mesh, parts), 3);
  expectVolumes(mesh, parts, { 1.0 / 6, 5.0 / 6 });
  EXPECT_EQ(mesh.nodeCount(), 8);
}

TEST(CellCut, IntoAHexagon)
{
  MeshEditor mesh = cube();
  CutParts parts;
  ASSERT_EQ(cut(mesh, 0, { 0.5, 0.5, 0.5 }, { 1, 1, 1 }, parts), 2);
  EXPECT_EQ(cornersBetween(mesh, parts), 6);
  EXPECT_NEAR(mesh.cell(0).volume, 0.5, 1e-12);
}

TEST(CellCut, AlongAFaceIsRefused)
{
  MeshEditor mesh = cube();
  for (const double x : { 0.0, 1.0, 0.02, 0.98, -1.0, 2.0 }) // or beside it, or outside
  {
    EXPECT_EQ(cut(mesh, 0, { x, 0.5, 0.5 }, { 1, 0, 0 }), 0) << x;
  }
  EXPECT_EQ(cut(mesh, 0, { 0, 0, 0 }, { 1, 1, 0 }), 0); // an edge
  EXPECT_EQ(cut(mesh, 0, { 0, 0, 0 }, { 1, 1, 1 }), 0); // a corner
}

// A plane that passes a node closely goes through it.
TEST(CellCut, NearNodes)
{
  MeshEditor mesh = cube();
  CutParts parts;
  ASSERT_EQ(cut(mesh, 0, { 0.52, 0.51, 0.5 }, { 1, 1.02, 0.01 }, parts), 2);
  EXPECT_EQ(mesh.nodeCount(), 8);
  expectVolumes(mesh, parts, { 0.5, 0.5 });
}

// Any plane: what remains is one, and as large, or it is refused.
TEST(CellCut, OfCubesAtRandom)
{
  std::mt19937 random(11);
  std::uniform_real_distribution<double> part(0, 1);
  int made = 0;
  for (int i = 0; i < 500; ++i)
  {
    MeshEditor mesh = meshOfBoxes(blockOfBoxes(3, 3, 3));
    const Vector through{ 1 + part(random), 1 + part(random), 1 + part(random) };
    const Vector normal{ part(random) - 0.5, part(random) - 0.5, part(random) - 0.5 };
    made += cut(mesh, 13, through, normal) == 2 ? 1 : 0;
    ASSERT_FALSE(testing::Test::HasFailure()) << i;
  }
  EXPECT_GT(made, 350);
}

// Cells beside it have the new nodes, and are closed: `cut` looks at that.
TEST(CellCut, GivesItsNodesToNeighbours)
{
  MeshEditor mesh = meshOfBoxes(blockOfBoxes(3, 3, 3));
  const std::size_t corners = mesh.cornersOf(faceBetween(mesh, 13, 14)).size();
  CutParts parts;
  ASSERT_EQ(cut(mesh, 13, { 1.5, 1.5, 1.5 }, { 1, 0, 0 }, parts), 2);
  EXPECT_EQ(corners, 4);
  EXPECT_EQ(mesh.facesOf(14).size(), 7); // one of them divided
  std::size_t larger = 0;                // beside the cell's edges that were divided
  for (std::uint32_t c = 0; c < 27; ++c)
  {
    for (const std::uint32_t f : mesh.facesOf(c))
    {
      larger += mesh.cornersOf(f).size() > 4 ? 1 : 0;
    }
  }
  EXPECT_EQ(larger, 16); // two faces at each of the four edges, as two cells have them
}

TEST(CellCut, OfAnLHasTwoParts)
{
  const std::vector<TestBox> boxes{ { { 0, 0, 0 }, { 1, 1, 1 } }, { { 1, 0, 0 }, { 2, 1, 1 } },
    { { 0, 1, 0 }, { 1, 2, 1 } } };
  MeshEditor mesh = cellOfBoxes(boxes);
  CutParts parts;
  ASSERT_EQ(cut(mesh, 0, { 1, 1, 0.5 }, { 1, 0, 0 }, parts), 2);
  expectVolumes(mesh, parts, { 1, 2 });
  mesh = cellOfBoxes(boxes);
  ASSERT_EQ(cut(mesh, 0, { 1, 1, 0.5 }, { 1, -1, 0 }, parts), 2); // along the bisector
  expectVolumes(mesh, parts, { 1.5, 1.5 });
}

// Across both arms of a diagonal cut: two sections, three parts.
TEST(CellCut, OfAUHasTwoSections)
{
  std::vector<TestBox> boxes = blockOfBoxes(3, 1, 1);
  boxes.push_back({ { 0, 1, 0 }, { 1, 2, 1 } });
  boxes.push_back({ { 2, 1, 0 }, { 3, 2, 1 } });
  MeshEditor mesh = cellOfBoxes(boxes);
  EXPECT_EQ(faultOf(mesh), "");
  CutParts parts;
  ASSERT_EQ(cut(mesh, 0, { 1.5, 1.5, 0.5 }, { 0, 1, 0 }, parts), 3);
  expectVolumes(mesh, parts, { 0.5, 0.5, 4 });
}

// ... and through the faces of both arms that lie in the plane of what is between them.
TEST(CellCut, OfAUAlongItsGround)
{
  std::vector<TestBox> boxes = blockOfBoxes(3, 1, 1);
  boxes.push_back({ { 0, 1, 0 }, { 1, 2, 1 } });
  boxes.push_back({ { 2, 1, 0 }, { 3, 2, 1 } });
  MeshEditor mesh = cellOfBoxes(boxes);
  CutParts parts;
  ASSERT_EQ(cut(mesh, 0, { 1.5, 1, 0.5 }, { 0, 1, 0 }, parts), 3);
  expectVolumes(mesh, parts, { 1, 1, 3 });
}

TEST(CellCut, OfADentedCellAlongItsBisector)
{
  for (const double depth : { 0.125, 0.5, 0.75 })
  {
    MeshEditor mesh = dentedCell(depth);
    CutParts parts;
    ASSERT_EQ(cut(mesh, 0, { 1, 0.5, 1 - depth }, { 1, 0, 0 }, parts), 2);
    EXPECT_DOUBLE_EQ(mesh.cell(parts[0]).volume, 1 - depth / 2);
    EXPECT_DOUBLE_EQ(mesh.cell(parts[1]).volume, 1 - depth / 2);
    EXPECT_EQ(cornersBetween(mesh, parts), 4);
  }
}

// Around a hole: boxes about one in the middle, which is another cell.
TEST(CellCut, RefusesASectionWithAHole)
{
  MeshEditor mesh = meshOfBoxes(blockOfBoxes(3, 3, 3));
  bool isAny = true;
  while (isAny)
  {
    isAny = false;
    for (std::uint32_t c = 1; c < 27; ++c)
    {
      isAny = (c != 13 && !mesh.cell(c).gone && faceBetween(mesh, 0, c) != None &&
                mergeCells(mesh, 0, c)) ||
        isAny;
    }
  }
  mesh.commit();
  ASSERT_EQ(countCells(mesh), 2);
  CutParts parts;
  EXPECT_FALSE(cutCell(mesh, 0, { { 1.5, 1.5, 1.5 }, { 0, 0, 1 }, Tolerance }, parts));
}

TEST(CellCut, HeldNodesStayOnTheirPlanes)
{
  std::mt19937 random(5);
  std::uniform_real_distribution<double> part(0, 1);
  for (int i = 0; i < 50; ++i)
  {
    TestMeshSpec spec;
    spec.constrainedAxes = 7;
    MeshEditor mesh = meshOfBoxes(blockOfBoxes(1, 1, 1), spec);
    const Vector normal{ part(random), part(random), part(random) };
    cut(mesh, 0, { 0.5, 0.5, 0.5 }, normal);
    for (std::uint32_t n = 8; n < mesh.nodeCount(); ++n)
    {
      const EditNode& node = mesh.node(n);
      int held = 0;
      for (std::size_t axis = 0; axis < 3; ++axis)
      {
        const bool isHeld = (node.constrainedAxes >> axis & 1) != 0;
        held += isHeld ? 1 : 0;
        EXPECT_EQ(isHeld, node.at[axis] == 0 || node.at[axis] == 1);
      }
      EXPECT_EQ(held, 2); // on an edge
      EXPECT_EQ(node.kind, NodeKind::OnEdge);
    }
  }
}

// On an edge of the wall that is none of its features, a new node may slide along the wall.
TEST(CellCut, KnowsWhatItsNodesAreOn)
{
  MeshEditor mesh = meshOfBoxes(blockOfBoxes(2, 2, 2));
  CutParts parts;
  ASSERT_EQ(cut(mesh, 0, { 0.5, 0.5, 0.5 }, { 1, 0, 0 }, parts), 2);
  std::array<int, 4> ofKind{};
  for (std::uint32_t n = 27; n < mesh.nodeCount(); ++n)
  {
    const EditNode& node = mesh.node(n);
    ++ofKind[std::size_t(node.kind)];
    EXPECT_EQ(node.atWall, node.kind != NodeKind::Free);
    EXPECT_EQ(node.referencePosition, node.at);
    EXPECT_GT(node.maxDisplacement, 0);
  }
  EXPECT_EQ(ofKind, (std::array<int, 4>{ 1, 2, 1, 0 }));
}

}
