// One mesh, byte for byte, for any number of threads.
#include "Pipeline.h"

#include <gtest/gtest.h>

using namespace cartesian;

namespace
{

void expectSame(const Soup& soup, const GridSpec& grid, const RefinementSpec& refinement)
{
  const Meshed one = meshOf(soup, grid, { asTheyAre(1e-3), 1, refinement });
  for (const int threads : { 2, 3, 8 })
  {
    SCOPED_TRACE(threads);
    const Meshed other = meshOf(soup, grid, { asTheyAre(1e-3), threads, refinement });
    EXPECT_TRUE(one.mesh == other.mesh);
    EXPECT_EQ(one.patches.points, other.patches.points);
    EXPECT_EQ(one.patches.corners, other.patches.corners);
    EXPECT_EQ(one.patches.triangle, other.patches.triangle);
    EXPECT_EQ(one.flawedBoxes, other.flawedBoxes);
    EXPECT_EQ(one.statistics, other.statistics);
  }
}

}

// Work comes in chunks of 512 boxes and 2048 triangles: enough of both for many.
TEST(Threads, DoNotChangeTheMesh)
{
  const Soup soup = bumpySphere(1, 25);
  expectSame(soup, cellsAlongLongest(soup, 25), {});
}

TEST(Threads, DoNotChangeARefinedMesh)
{
  const Soup soup = bumpySphere(2, 10);
  expectSame(soup, cellsAlongLongest(soup, 9), depth(2));
}

TEST(Threads, DoNotChangeTheMeshOfAFlawedSurface)
{
  Soup soup = bumpySphere(3, 12);
  soup.triangles.erase(soup.triangles.begin() + 100, soup.triangles.begin() + 140);
  soup.boundary.clear();
  expectSame(soup, cellsAlongLongest(soup, 20), {});
}
