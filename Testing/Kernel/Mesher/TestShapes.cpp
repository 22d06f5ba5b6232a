// The mesh of every shape is valid and fills it, whatever the size of the cells.
#include "Base/Error.h"
#include "Support/MeshChecker.h"

#include <gtest/gtest.h>

#include <cmath>

using namespace cartesian;

namespace
{

// One box around all, few boxes, meshlines through planes of symmetry, and sizes that divide nothing.
constexpr std::array<double, 6> CellsAlongLongest = { 0.1, 1, 2, 3.7, 8, 11.3 };

class CleanShape : public ::testing::TestWithParam<NamedShape>
{
};

class ThinShape : public ::testing::TestWithParam<NamedShape>
{
};

}

TEST_P(CleanShape, MeshIsValidAndFillsTheSurface)
{
  const Soup& soup = GetParam().soup;
  for (const double cells : CellsAlongLongest)
  {
    SCOPED_TRACE(std::to_string(cells) + " cells along the longest dimension");
    const Meshed meshed = meshOf(soup, cellsAlongLongest(soup, cells));
    EXPECT_TRUE(isValid(meshed.mesh));
    EXPECT_TRUE(fills(meshed.mesh, soup));
    EXPECT_TRUE(meshed.flawedBoxes.empty());
  }
}

TEST_P(CleanShape, RefinedMeshIsValidAndFillsTheSurface)
{
  const Soup& soup = GetParam().soup;
  for (const int levels : { 1, 2 })
  {
    SCOPED_TRACE("depth " + std::to_string(levels));
    const Meshed meshed = meshOf(soup, cellsAlongLongest(soup, 2.9), asTheyAre(0, depth(levels)));
    EXPECT_TRUE(isValid(meshed.mesh));
    EXPECT_TRUE(fills(meshed.mesh, soup));
    EXPECT_TRUE(meshed.flawedBoxes.empty());
  }
}

// What is lost is less than R of each box that the surface passes through.
TEST_P(CleanShape, SmallCellsAreRemoved)
{
  const Soup& soup = GetParam().soup;
  for (const double ratio : { 1e-3, 0.3 })
  {
    SCOPED_TRACE("small cell ratio " + std::to_string(ratio));
    const double size = soup.longest() / 6.1;
    try
    {
      const Meshed meshed = meshOf(soup, cellsOf(size), asTheyAre(ratio));
      EXPECT_TRUE(isValid(meshed.mesh));
      for (const double fraction : meshed.mesh.volumeFraction)
      {
        EXPECT_GE(fraction, ratio);
      }
      const double most = ratio * std::pow(size, 3) * meshed.statistics.at("SmallCellsRemoved");
      EXPECT_LE(
        std::abs(soup.volume() - volumeOf(meshed.mesh)), most + volumeSlack(meshed.mesh, soup));
    }
    catch (const Error& error)
    {
      EXPECT_EQ(error.fault, Fault::FlawedSurface) << error.what();
      EXPECT_LT(soup.volume(), ratio * std::pow(soup.longest() + size, 3));
    }
  }
}

INSTANTIATE_TEST_SUITE_P(Of, CleanShape, ::testing::ValuesIn(cleanShapes()), nameOf);

TEST_P(ThinShape, MeshIsValidWhereTheLatticeLosesWalls)
{
  const Soup& soup = GetParam().soup;
  for (const double cells : CellsAlongLongest)
  {
    SCOPED_TRACE(std::to_string(cells) + " cells along the longest dimension");
    try
    {
      EXPECT_TRUE(isValid(meshOf(soup, cellsAlongLongest(soup, cells)).mesh));
    }
    catch (const Error& error)
    {
      EXPECT_EQ(error.fault, Fault::FlawedSurface) << error.what();
    }
  }
}

TEST_P(ThinShape, MeshFillsTheSurfaceWhereTheLatticeHoldsIt)
{
  const Soup& soup = GetParam().soup;
  const Meshed meshed = meshOf(soup, cellsAlongLongest(soup, 7));
  EXPECT_TRUE(isValid(meshed.mesh));
  EXPECT_TRUE(fills(meshed.mesh, soup));
  EXPECT_TRUE(meshed.flawedBoxes.empty());
}

INSTANTIATE_TEST_SUITE_P(Of, ThinShape, ::testing::ValuesIn(thinShapes()), nameOf);
