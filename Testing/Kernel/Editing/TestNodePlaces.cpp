// Nodes at one place, and what becomes of them.
#include "Editing/NodePlaces.h"
#include "Support/EditMeshes.h"

#include <gtest/gtest.h>

#include <set>

namespace cartesian
{

namespace
{

std::vector<Vector> placesOf(const MeshEditor& mesh)
{
  std::vector<Vector> places;
  for (std::uint32_t n = 0; n < mesh.nodeCount(); ++n)
  {
    places.push_back(mesh.node(n).at);
  }
  return places;
}

TEST(NodePlaces, DifferFromEachOther)
{
  MeshEditor mesh = meshOfBoxes(blockOfBoxes(2, 2, 2));
  mesh.mesh().level = 1.0 / 1024;
  const Vector place = mesh.node(5).at;
  for (const std::uint32_t n : { 7U, 3U, 11U, 20U })
  {
    mesh.rawNode(n).at = place;
  }
  mesh.rawNode(7).constrainedAxes = AllAxes;
  mesh.rawNode(11).constrainedAxes = 5; // may move along y alone
  const std::vector<Vector> before = placesOf(mesh);
  Execution execution(1);
  separateNodes(mesh.mesh(), ObjectiveSpec(), execution);
  const std::vector<Vector> after = placesOf(mesh);
  EXPECT_EQ(std::set<Vector>(after.begin(), after.end()).size(), after.size());
  EXPECT_EQ(after[7], place);
  EXPECT_EQ(after[11][0], place[0]);
  EXPECT_EQ(after[11][2], place[2]);
  for (std::size_t n = 0; n < after.size(); ++n)
  {
    EXPECT_LE(norm(minus(after[n], before[n])), 2.0 / 1024) << n;
    EXPECT_TRUE(before[n] == place || after[n] == before[n]) << n;
  }
}

// What moved is measured: a mesh that is measured again is the same. Nodes of an edge without length part.
TEST(NodePlaces, AreMeasured)
{
  MeshEditor mesh = meshOfBoxes(blockOfBoxes(2, 2, 2));
  mesh.mesh().level = 1.0 / 1024;
  const std::uint32_t inner = nodeAt(mesh, { 1, 1, 1 });
  const std::uint32_t beside = nodeAt(mesh, { 1, 1, 2 });
  mesh.rawNode(inner).at = mesh.node(beside).at;
  measureAgain(mesh);
  Execution execution(1);
  separateNodes(mesh.mesh(), ObjectiveSpec(), execution);
  ASSERT_NE(mesh.node(inner).at, mesh.node(beside).at);
  MeshEditor again = copyOf(mesh);
  measureAgain(again);
  for (std::uint32_t c = 0; c < mesh.cellCount(); ++c)
  {
    EXPECT_DOUBLE_EQ(mesh.cell(c).volume, again.cell(c).volume) << c;
  }
  for (std::uint32_t f = 0; f < mesh.faceCount(); ++f)
  {
    EXPECT_DOUBLE_EQ(norm(mesh.face(f).area), norm(again.face(f).area)) << f;
    EXPECT_DOUBLE_EQ(mesh.face(f).cost, again.face(f).cost) << f;
  }
}

}

}
