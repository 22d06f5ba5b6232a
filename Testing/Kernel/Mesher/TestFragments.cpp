// What the grid cuts off from a body is left out; a body that is thin for a while stays whole, and so does a small body of
// its own (Cells/Fragments.h).
#include "Support/MeshChecker.h"
#include "Support/Pipeline.h"

#include <gtest/gtest.h>

using namespace cartesian;

namespace
{

// At 1.03, the bead is in two boxes of each direction.
Meshed meshOfBead(const Soup& soup, double refusedCellRatio)
{
  TestOptions options;
  options.shaping.refusedCellRatio = refusedCellRatio;
  return meshOf(soup, cellsOf(1.03), options);
}

double farthest(const MeshArrays& mesh)
{
  double x = 0;
  for (std::size_t p = 0; p < mesh.points.size(); p += 3)
  {
    x = std::max(x, mesh.points[p]);
  }
  return x;
}

}

TEST(Fragments, GoWhereTheGridCutsThemOff)
{
  const Meshed cut = meshOfBead(beadOnAThread(0.001), 1);
  EXPECT_GT(cut.statistics.at("FragmentCellsRemoved"), 0);
  EXPECT_EQ(cut.statistics.at("IsolatedCells"), 0);
  EXPECT_LT(farthest(cut.mesh), 7);
}

TEST(Fragments, AreNoneOnAThreadOfAThirtiethOfABox)
{
  for (const double thickness : { 0.1, 0.03 })
  {
    const Soup soup = beadOnAThread(thickness);
    const Meshed whole = meshOfBead(soup, 1);
    EXPECT_TRUE(isValid(whole.mesh, true));
    EXPECT_EQ(whole.statistics.at("FragmentCellsRemoved"), 0);
    EXPECT_EQ(whole.statistics.at("IsolatedCells"), 0);
    EXPECT_NEAR(farthest(whole.mesh), 7.8, 1e-6);
    EXPECT_NEAR(volumeOf(whole.mesh), soup.volume(), 1e-5 * soup.volume());
  }
}

TEST(Fragments, StayWhereNothingIsToBeRemoved)
{
  const Meshed whole = meshOfBead(beadOnAThread(0.0001), 0);
  EXPECT_EQ(whole.statistics.at("FragmentCellsRemoved"), 0);
  EXPECT_GT(whole.statistics.at("IsolatedCells"), 0);
  EXPECT_NEAR(farthest(whole.mesh), 7.8, 1e-6);
}

TEST(Fragments, AreNoBodiesOfTheirOwn)
{
  const Soup soup = box({ 0, 0, 0 }, { 4, 4, 4 }).add(box({ 7, 1.6, 1.6 }, { 7.8, 2.4, 2.4 }));
  const Meshed both = meshOfBead(soup, 1);
  EXPECT_EQ(both.statistics.at("FragmentCellsRemoved"), 0);
  EXPECT_GT(both.statistics.at("IsolatedCells"), 0);
  EXPECT_NEAR(farthest(both.mesh), 7.8, 1e-6);
}
