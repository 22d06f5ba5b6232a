// The checker itself: it accepts a good mesh and notices every change to it.
#include "Support/MeshChecker.h"

#include <gtest/gtest.h>

using namespace cartesian;

namespace
{

const Soup& surface()
{
  static const Soup soup = bumpySphere(5, 4);
  return soup;
}

MeshArrays goodMesh()
{
  static const MeshArrays mesh = meshOf(surface(), cellsAlongLongest(surface(), 7)).mesh;
  return mesh;
}

void expectComplaint(const MeshArrays& mesh, const std::string& words)
{
  const ::testing::AssertionResult result = isValid(mesh);
  EXPECT_FALSE(result);
  EXPECT_NE(std::string(result.message()).find(words), std::string::npos) << result.message();
}

std::size_t firstPolyhedron(const MeshArrays& mesh)
{
  std::size_t cell = 0;
  while (mesh.types[cell] != MeshArrays::Polyhedron)
  {
    ++cell;
  }
  return cell;
}

// The number of points, and then the points, of a polyhedron's first face.
Id* firstFace(MeshArrays& mesh, std::size_t cell)
{
  return mesh.faceStream.data() + mesh.faceStart[cell] + 1;
}

}

TEST(MeshChecker, AcceptsAGoodMesh)
{
  const MeshArrays mesh = goodMesh();
  EXPECT_TRUE(isValid(mesh));
  EXPECT_TRUE(fills(mesh, surface()));
  EXPECT_GT(std::count(mesh.types.begin(), mesh.types.end(), MeshArrays::Hexahedron), 0);
}

TEST(MeshChecker, SeesAFaceTurnedOver)
{
  MeshArrays mesh = goodMesh();
  Id* face = firstFace(mesh, firstPolyhedron(mesh));
  std::reverse(face + 1, face + 1 + *face);
  expectComplaint(mesh, "is not closed");
}

TEST(MeshChecker, SeesAMissingFace)
{
  MeshArrays mesh = goodMesh();
  const std::size_t cell = firstPolyhedron(mesh);
  const Id size = *firstFace(mesh, cell) + 1;
  --mesh.faceStream[static_cast<std::size_t>(mesh.faceStart[cell])];
  mesh.faceStream.erase(mesh.faceStream.begin() + mesh.faceStart[cell] + 1,
    mesh.faceStream.begin() + mesh.faceStart[cell] + 1 + size);
  for (Id& start : mesh.faceStart)
  {
    start -= start > mesh.faceStart[cell] ? size : 0;
  }
  expectComplaint(mesh, "is not closed");
}

TEST(MeshChecker, SeesAFaceFromBothSides)
{
  MeshArrays mesh = goodMesh();
  const std::size_t cell = firstPolyhedron(mesh);
  const Id* face = firstFace(mesh, cell);
  const std::vector<Id> twins = { 3, face[1], face[2], face[3], 3, face[3], face[2], face[1] };
  mesh.faceStream[static_cast<std::size_t>(mesh.faceStart[cell])] += 2;
  mesh.faceStream.insert(
    mesh.faceStream.begin() + mesh.faceStart[cell] + 1, twins.begin(), twins.end());
  for (Id& start : mesh.faceStart)
  {
    start += start > mesh.faceStart[cell] ? static_cast<Id>(twins.size()) : 0;
  }
  expectComplaint(mesh, "from both sides");
}

TEST(MeshChecker, SeesACellInsideOut)
{
  MeshArrays mesh = goodMesh();
  const std::size_t cell = firstPolyhedron(mesh);
  Id* face = firstFace(mesh, cell);
  for (Id f = 0; f < mesh.faceStream[static_cast<std::size_t>(mesh.faceStart[cell])]; ++f)
  {
    std::reverse(face + 1, face + 1 + *face);
    face += *face + 1;
  }
  expectComplaint(mesh, "has the volume -");
}

TEST(MeshChecker, SeesAHexahedronInWrongOrder)
{
  MeshArrays mesh = goodMesh();
  const auto cell = std::find(mesh.types.begin(), mesh.types.end(), MeshArrays::Hexahedron);
  const auto at = static_cast<std::size_t>(cell - mesh.types.begin());
  Id* points = mesh.connectivity.data() + mesh.offsets[at];
  std::swap(points[2], points[3]); // as in a vtkVoxel
  std::swap(points[6], points[7]);
  expectComplaint(mesh, "another volume fraction");
  expectComplaint(mesh, "not listed as boundary");
}

TEST(MeshChecker, SeesABoundaryFaceThatIsNotListed)
{
  MeshArrays mesh = goodMesh();
  mesh.boundaryCell.pop_back();
  mesh.boundaryIndex.pop_back();
  mesh.boundaryStart.pop_back();
  expectComplaint(mesh, "not listed as boundary");
  expectComplaint(mesh, "the boundary is open");
}

TEST(MeshChecker, SeesABoundaryFaceListedTwice)
{
  MeshArrays mesh = goodMesh();
  for (Id i = mesh.boundaryStart[0]; i < mesh.boundaryStart[1]; ++i)
  {
    mesh.boundaryPoints.push_back(mesh.boundaryPoints[static_cast<std::size_t>(i)]);
  }
  mesh.boundaryStart.push_back(static_cast<Id>(mesh.boundaryPoints.size()));
  mesh.boundaryCell.push_back(mesh.boundaryCell[0]);
  mesh.boundaryIndex.push_back(0);
  expectComplaint(mesh, "or listed twice");
}

TEST(MeshChecker, SeesAWrongOwner)
{
  MeshArrays mesh = goodMesh();
  mesh.boundaryCell[0] = mesh.boundaryCell.back();
  expectComplaint(mesh, "is no face of its cell");
}

// A cell with its own copy of a point that its neighbours use.
TEST(MeshChecker, SeesNeighboursThatDoNotMeet)
{
  MeshArrays mesh = goodMesh();
  const auto copy = static_cast<Id>(mesh.points.size() / 3);
  const std::size_t cell = firstPolyhedron(mesh);
  const Id point = mesh.connectivity[static_cast<std::size_t>(mesh.offsets[cell])];
  for (int axis = 0; axis < 3; ++axis)
  {
    mesh.points.push_back(mesh.points[3 * static_cast<std::size_t>(point) + axis]);
  }
  mesh.connectivity[static_cast<std::size_t>(mesh.offsets[cell])] = copy;
  const auto begin = mesh.faceStream.begin() + mesh.faceStart[cell] + 1;
  auto face = begin;
  for (Id f = 0; f < *(begin - 1); ++f)
  {
    std::replace(face + 1, face + 1 + *face, point, copy);
    face += *face + 1;
  }
  expectComplaint(mesh, "coincides with another");
  expectComplaint(mesh, "not listed as boundary");
}

TEST(MeshChecker, SeesAnUnusedPoint)
{
  MeshArrays mesh = goodMesh();
  mesh.points.insert(mesh.points.end(), { 10, 20, 30 });
  expectComplaint(mesh, "is unused");
}

TEST(MeshChecker, SeesAPointElsewhere)
{
  MeshArrays mesh = goodMesh();
  mesh.points[0] += 1;
  expectComplaint(mesh, "another volume fraction");
  expectComplaint(mesh, "leaves its box");
}

TEST(MeshChecker, SeesWrongCellData)
{
  MeshArrays mesh = goodMesh();
  mesh.volumeFraction[3] *= 1.0001;
  expectComplaint(mesh, "cell 3 has another volume fraction");
  mesh = goodMesh();
  mesh.region[2] = OutsideRegion;
  expectComplaint(mesh, "cell 2 is in no region");
  mesh = goodMesh();
  mesh.globalBox[0] += 1;
  expectComplaint(mesh, "cell 0 leaves its box");
}

TEST(MeshChecker, SeesAnUnfilledSurface)
{
  const MeshArrays mesh = goodMesh();
  EXPECT_FALSE(fills(mesh, surface().scaled(1 + 1e-8)));
  EXPECT_FALSE(fills(mesh, bumpySphere(6, 4)));
}

TEST(MeshChecker, SeesABoundaryOfAnotherIndex)
{
  MeshArrays mesh = goodMesh();
  mesh.boundaryIndex[0] += 1;
  const ::testing::AssertionResult result = fills(mesh, surface());
  EXPECT_FALSE(result);
  EXPECT_NE(std::string(result.message()).find("area of boundary"), std::string::npos);
}
