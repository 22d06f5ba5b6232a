// One mesh, byte for byte, for any number of threads.
#include "Support/Effort.h"
#include "Support/Pipeline.h"
#include "Support/ThreadLimit.h"

#include <gtest/gtest.h>

using namespace cartesian;

namespace
{

void expectSameWith(const Soup& soup, const GridSpec& grid, TestOptions options)
{
  const Meshed one = meshOf(soup, grid, options);
  for (const int threads : cases({ 2, 3, 8 }))
  {
    SCOPED_TRACE(threads);
    options.threads = threads;
    const Meshed other = meshOf(soup, grid, options);
    EXPECT_TRUE(one.mesh == other.mesh);
    EXPECT_EQ(one.patches.points, other.patches.points);
    EXPECT_EQ(one.patches.kinds, other.patches.kinds);
    EXPECT_EQ(one.patches.corners, other.patches.corners);
    EXPECT_EQ(one.patches.triangle, other.patches.triangle);
    EXPECT_EQ(one.flawedBoxes, other.flawedBoxes);
    EXPECT_EQ(one.statistics, other.statistics);
  }
}

void expectSame(const Soup& soup, const GridSpec& grid, const RefinementSpec& refinement)
{
  expectSameWith(soup, grid, asTheyAre(1e-3, refinement));
  TestOptions options;
  options.refinement = refinement;
  expectSameWith(soup, grid, options);
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

// Sides come in chunks of 256 there, and boxes in chunks of 64.
TEST(Threads, DoNotChangeBoxesMadeAnew)
{
  const Soup soup = kleinBottle(12);
  const GridSpec grid = cellsAlongLongest(soup, 25);
  EXPECT_GT(meshOf(soup, grid).statistics.at("BoxesRebuilt"), 3 * 64);
  expectSameWith(soup, grid, {});
}

TEST(Threads, ThatCannotBeStartedDoNotChangeTheMesh)
{
  const Soup soup = bumpySphere(1, 10);
  const GridSpec grid = cellsAlongLongest(soup, 25);
  TestOptions options;
  const Meshed one = meshOf(soup, grid, options);
  options.threads = 8;
  for (const unsigned most : { 0U, 1U })
  {
    const ThreadLimit limit(most);
    const Meshed other = meshOf(soup, grid, options);
    EXPECT_TRUE(one.mesh == other.mesh);
    EXPECT_EQ(one.statistics, other.statistics);
  }
}
