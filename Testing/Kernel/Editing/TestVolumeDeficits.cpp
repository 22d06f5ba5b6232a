// What walls owe is passed on in full, however many an edit changes; how far they move is known or refused.
#include "Editing/EditMeasures.h"
#include "Editing/VolumeDeficits.h"
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
MeshEditor risen(int n)
{
  MeshEditor mesh = meshOfBoxes(blockOfBoxes(n, n, 1));
  for (std::uint32_t f = 0; f < mesh.faceCount(); ++f)
  {
    mesh.rawFace(f).volumeDeficit = mesh.isWall(f) ? 0.001 * (f % 7) : 0;
  }
  static_cast<void>(mesh.mark());
  for (std::uint32_t node = 0; node < mesh.nodeCount(); ++node)
  {
    if (mesh.node(node).at[2] == 1)
    {
      mesh.changeNode(node).at[2] += Rise;
      for (const std::uint32_t f : mesh.facesAround(node))
      {
        mesh.dirty.faces.add(f);
      }
    }
  }
  EXPECT_TRUE(measureDirty(mesh));
  return mesh;
}

}

TEST(VolumeDeficits, OfManyWallsArePassedOnInFull)
{
  for (const int n : { 3, 25 })
  {
    SCOPED_TRACE(n);
    MeshEditor mesh = risen(n);
    const double before = sumOfDeficits(mesh);
    passOnDeficits(mesh);
    mesh.commit();
    EXPECT_NEAR(sumOfDeficits(mesh), before - n * n * Rise, 1e-9);
  }
}

TEST(WallEdges, DistancesOfTooManyWallsAreInfinite)
{
  for (const int n : { 3, 20 })
  {
    EXPECT_NEAR(distanceOfWalls(risen(n), MeshEditor::Mark{}), Rise, 1e-12);
  }
  EXPECT_TRUE(std::isinf(distanceOfWalls(risen(40), MeshEditor::Mark{})));
}

}
