// Points with two edges in meshes for solvers that refine; Testing/Validation/TestRefining.py runs one.
#include "OpenFoam/ThirdEdges.h"

#include <gtest/gtest.h>

#include <set>

namespace cartesian
{
namespace
{

// A cube whose top is a triangle beside one side, and a polygon around it that alone has its inner corner (8), too.
FoamMesh cube(std::vector<FoamPatch> patches)
{
  FoamMesh mesh{};
  mesh.points = { 0, 0, 0, 1, 0, 0, 1, 1, 0, 0, 1, 0, 0, 0, 1, 1, 0, 1, 1, 1, 1, 0, 1, 1, 0.5, 0.2,
    1 };
  const std::vector<std::vector<std::uint32_t>> faces = { { 0, 3, 2, 1 }, { 4, 5, 8 },
    { 4, 8, 5, 6, 7 }, { 0, 1, 5, 4 }, { 1, 2, 6, 5 }, { 2, 3, 7, 6 }, { 3, 0, 4, 7 } };
  mesh.start = { 0 };
  std::vector<std::uint32_t> corners;
  for (const std::vector<std::uint32_t>& face : faces)
  {
    corners.insert(corners.end(), face.begin(), face.end());
    mesh.start.push_back(corners.size());
  }
  mesh.corners.resize(corners.size());
  std::copy(corners.begin(), corners.end(), mesh.corners.data());
  mesh.owner.assign(faces.size(), 0);
  mesh.cellCount = 1;
  mesh.patches = std::move(patches);
  return mesh;
}

std::size_t edgesAt(const FoamMesh& mesh, std::uint32_t point)
{
  std::set<std::uint32_t> others;
  for (std::size_t f = 0; f < mesh.owner.size(); ++f)
  {
    const std::size_t size = mesh.start[f + 1] - mesh.start[f];
    for (std::size_t i = 0; i < size; ++i)
    {
      if (mesh.corners[mesh.start[f] + i] == point)
      {
        others.insert(mesh.corners[mesh.start[f] + (i + 1) % size]);
        others.insert(mesh.corners[mesh.start[f] + (i + size - 1) % size]);
      }
    }
  }
  return others.size();
}

TEST(ThirdEdges, DivideALargerFace)
{
  const FoamMesh before = cube({ { "a", 2 }, { "b", 5 } });
  ASSERT_EQ(edgesAt(before, 8), 2u);
  const FoamMesh after = withThirdEdges(before);
  EXPECT_EQ(edgesAt(after, 8), 3u);
  EXPECT_EQ(after.points, before.points);
  EXPECT_EQ(after.owner, std::vector<std::uint32_t>(8, 0));
  EXPECT_EQ(after.patches[0].count, 2u);
  EXPECT_EQ(after.patches[1].count, 6u);
}

TEST(ThirdEdges, StayAsTheyAreElsewhere)
{
  const FoamMesh once = withThirdEdges(cube({ { "a", 7 } }));
  const FoamMesh twice = withThirdEdges(once);
  EXPECT_EQ(twice.start, once.start);
}

}
}
