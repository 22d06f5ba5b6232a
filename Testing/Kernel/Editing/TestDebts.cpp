// What walls owe is passed on in full, however many an edit changes; how far they move is known or refused.
#include "Editing/Debts.h"
#include "Editing/EditMeasures.h"
#include "Editing/WallEdges.h"
#include "Support/EditMeshes.h"

#include <gtest/gtest.h>

#include <cmath>

namespace cartesian
{

namespace
{

constexpr double Rise = 1.0 / 64;

// The upper walls of n x n boxes rise in one edit.
EditMesh risen(int n)
{
  EditMesh mesh = meshOfBoxes(blockOfBoxes(n, n, 1));
  for (std::uint32_t f = 0; f < mesh.faceCount(); ++f)
  {
    mesh.rawFace(f).debt = mesh.isWall(f) ? 0.001 * (f % 7) : 0;
  }
  static_cast<void>(mesh.mark());
  for (std::uint32_t node = 0; node < mesh.nodeCount(); ++node)
  {
    if (mesh.node(node).at[2] == 1)
    {
      mesh.changeNode(node).at[2] += Rise;
      for (const std::uint32_t f : mesh.facesAround(node))
      {
        mesh.unsettled.faces.add(f);
      }
    }
  }
  EXPECT_TRUE(measureUnsettled(mesh));
  return mesh;
}

double sumOfDebts(const EditMesh& mesh)
{
  double sum = 0;
  for (std::uint32_t f = 0; f < mesh.faceCount(); ++f)
  {
    sum += mesh.isWall(f) ? mesh.signOf(f) * mesh.face(f).debt : 0;
  }
  return sum;
}

}

TEST(Debts, OfManyWallsArePassedOnInFull)
{
  for (const int n : { 3, 25 })
  {
    SCOPED_TRACE(n);
    EditMesh mesh = risen(n);
    const double before = sumOfDebts(mesh);
    passOnDebts(mesh);
    mesh.commit();
    EXPECT_NEAR(sumOfDebts(mesh), before - n * n * Rise, 1e-9);
  }
}

TEST(WallEdges, DistancesOfTooManyWallsAreInfinite)
{
  for (const int n : { 3, 20 })
  {
    EXPECT_NEAR(distanceOfWalls(risen(n), EditMesh::Mark{}), Rise, 1e-12);
  }
  EXPECT_TRUE(std::isinf(distanceOfWalls(risen(40), EditMesh::Mark{})));
}

}
