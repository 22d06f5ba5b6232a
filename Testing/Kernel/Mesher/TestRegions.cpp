// Several regions in one mesh: cells of two regions share the faces between them.
#include "Base/Error.h"
#include "Support/MeshChecker.h"

#include <gtest/gtest.h>

using namespace cartesian;

namespace
{

// Volumes and areas that a mesh of several regions must have. Region 0 is outside.
struct Expected
{
  std::map<int, double> volumes;
  std::map<std::pair<int, int>, double> areas;
};

void expectRegions(const MeshArrays& mesh, const Expected& expected, double slack)
{
  const std::map<int, double> volumes = volumesByRegion(mesh);
  ASSERT_EQ(volumes.size(), expected.volumes.size());
  for (const auto& [region, volume] : expected.volumes)
  {
    EXPECT_NEAR(volumes.at(region), volume, slack * volume) << "region " << region;
  }
  const auto areas = areasBetweenRegions(mesh);
  ASSERT_EQ(areas.size(), expected.areas.size());
  for (const auto& [regions, area] : expected.areas)
  {
    EXPECT_NEAR(areas.at(regions), area, slack * area)
      << "between " << regions.first << " and " << regions.second;
  }
}

// By Exact Fit: with cells as they are, then with cells that solvers accept.
void expectExactly(const Soup& soup, const Expected& expected)
{
  for (const double cells : { 1.0, 3.7, 8.0, 11.3 })
  {
    for (const int levels : { 0, 1 })
    {
      SCOPED_TRACE(std::to_string(cells) + " cells along the longest dimension, depth " +
        std::to_string(levels));
      const GridSpec grid = cellsAlongLongest(soup, cells);
      const Meshed asIs = meshOf(soup, grid, asTheyAre(0, depth(levels)));
      EXPECT_TRUE(isValid(asIs.mesh));
      expectRegions(asIs.mesh, expected, 1e-9);
      TestOptions options;
      options.patches = exactFit();
      options.refinement = depth(levels);
      const Meshed shaped = meshOf(soup, grid, options);
      EXPECT_TRUE(isValid(shaped.mesh, true));
      expectRegions(shaped.mesh, expected, 1e-9);
    }
  }
}

// With the user's defaults.
void expectNearly(const Soup& soup, const Expected& expected, double slack)
{
  for (const double cells : { 3.7, 8.0, 11.3 })
  {
    for (const int levels : { 0, 1 })
    {
      SCOPED_TRACE(std::to_string(cells) + " cells along the longest dimension, depth " +
        std::to_string(levels));
      TestOptions options;
      options.refinement = depth(levels);
      const Meshed meshed = meshOf(soup, cellsAlongLongest(soup, cells), options);
      EXPECT_TRUE(isValid(meshed.mesh, true));
      expectRegions(meshed.mesh, expected, slack);
    }
  }
}

void expectRefusal(const Soup& soup, const std::string& words)
{
  try
  {
    meshOf(soup, cellsAlongLongest(soup, 5));
    FAIL() << "no error";
  }
  catch (const Error& error)
  {
    EXPECT_EQ(error.fault, Fault::FlawedSurface);
    EXPECT_NE(std::string(error.what()).find(words), std::string::npos) << error.what();
  }
}

Soup twoBoxes()
{
  Soup soup;
  soup.addRegion(box({ 0, 0, 0 }, { 1, 1, 1 }));
  soup.addRegion(box({ 1, 0, 0 }, { 3, 1, 1 }));
  return soup;
}

const Expected OfTwoBoxes{ { { 1, 1 }, { 2, 2 } },
  { { { 0, 1 }, 5 }, { { 0, 2 }, 9 }, { { 1, 2 }, 1 } } };

Soup boxInBox()
{
  Soup soup;
  soup.addRegion(box({ 0.25, 0.25, 0.375 }, { 0.75, 0.875, 0.625 }));
  soup.addRegion(cube());
  return soup;
}

const Expected OfBoxInBox{ { { 1, 0.078125 }, { 2, 0.921875 } },
  { { { 0, 2 }, 6 }, { { 1, 2 }, 1.1875 } } };

}

TEST(Regions, ShareTheirCommonTriangles)
{
  Soup soup;
  soup.addRegion(cube());
  soup.addRegion(
    cube().each([](const Vector& p) { return Vector{ 3 - 2 * p[0], p[1], p[2] }; }).flipped());
  expectExactly(soup, OfTwoBoxes);
  expectNearly(soup, OfTwoBoxes, 3e-5);
}

TEST(Regions, ShareTheirCommonWall)
{
  expectExactly(twoBoxes(), OfTwoBoxes);
  expectNearly(twoBoxes(), OfTwoBoxes, 3e-5);
}

TEST(Regions, MayLieInEachOther)
{
  expectExactly(boxInBox(), OfBoxInBox);
  expectNearly(boxInBox(), OfBoxInBox, 3e-5);
}

TEST(Regions, TheFirstKeepsTheVolume)
{
  Soup soup;
  soup.addRegion(cube());
  soup.addRegion(box({ 0.3, 0.2, 0.4 }, { 0.7, 0.8, 0.6 }));
  expectRefusal(soup, "Nothing is left of region 2");
}
