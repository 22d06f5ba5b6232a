// Several regions in one mesh: cells of two regions share the faces between them.
#include "Base/Error.h"
#include "Support/MeshChecker.h"

#include <gtest/gtest.h>

#include <numeric>

using namespace cartesian;

namespace
{

// Volumes and areas that a mesh of several regions must have. Region 0 is outside.
struct Expected
{
  std::map<int, double> volumes;
  std::map<std::pair<int, int>, double> areas;
};

void expectRegions(const MeshArrays& mesh, const Expected& expected, double part)
{
  // Or two steps of the lattice.
  const auto slackOf = [&](double whole) { return std::max(part * whole, 20 * mesh.step); };
  const std::map<int, double> volumes = volumesByRegion(mesh);
  ASSERT_EQ(volumes.size(), expected.volumes.size());
  for (const auto& [region, volume] : expected.volumes)
  {
    EXPECT_NEAR(volumes.at(region), volume, slackOf(volume)) << "region " << region;
  }
  const auto areas = areasBetweenRegions(mesh);
  ASSERT_EQ(areas.size(), expected.areas.size());
  for (const auto& [regions, area] : expected.areas)
  {
    EXPECT_NEAR(areas.at(regions), area, slackOf(area))
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
  soup.addRegion(cube()
                   .each([](const Vector& p) {
                     return Vector{ 3 - 2 * p[0], p[1], p[2] };
                   })
                   .flipped());
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

TEST(Regions, ShareAPartOfAWall)
{
  Soup soup;
  soup.addRegion(cube());
  soup.addRegion(box({ 1, 0.25, -0.5 }, { 2, 0.75, 0.625 }));
  const Expected expected{ { { 1, 1 }, { 2, 0.5625 } },
    { { { 0, 1 }, 6 - 0.3125 }, { { 0, 2 }, 2 * (0.5 + 0.5625 + 1.125) - 0.3125 },
      { { 1, 2 }, 0.3125 } } };
  expectExactly(soup, expected);
  expectNearly(soup, expected, 3e-5);
}

TEST(Regions, MeetAlongOneEdge)
{
  Soup soup;
  soup.addRegion(cube());
  soup.addRegion(box({ 1, 0, 0 }, { 2, 1, 1 }));
  soup.addRegion(box({ 0, 1, 0 }, { 2, 2, 1 }));
  const Expected expected{ { { 1, 1 }, { 2, 1 }, { 3, 2 } },
    { { { 0, 1 }, 4 }, { { 0, 2 }, 4 }, { { 0, 3 }, 8 }, { { 1, 2 }, 1 }, { { 1, 3 }, 1 },
      { { 2, 3 }, 1 } } };
  expectExactly(soup, expected);
  expectNearly(soup, expected, 3e-5);
}

TEST(Regions, MayBeThinnerThanABoxBetweenOthers)
{
  Soup soup;
  soup.addRegion(cube());
  soup.addRegion(box({ 1, 0, 0 }, { 1.0078125, 1, 1 }));
  soup.addRegion(box({ 1.0078125, 0, 0 }, { 2, 1, 1 }));
  const double thickness = 0.0078125;
  const Expected expected{ { { 1, 1 }, { 2, thickness }, { 3, 1 - thickness } },
    { { { 0, 1 }, 5 }, { { 0, 2 }, 4 * thickness }, { { 0, 3 }, 1 + 4 * (1 - thickness) },
      { { 1, 2 }, 1 }, { { 2, 3 }, 1 } } };
  expectExactly(soup, expected);
  expectNearly(soup, expected, 3e-3);
}

TEST(Regions, LieInEachOtherTwice)
{
  Soup soup;
  soup.addRegion(box({ 0.375, 0.375, 0.375 }, { 0.625, 0.625, 0.625 }));
  soup.addRegion(box({ 0.25, 0.25, 0.25 }, { 0.75, 0.75, 0.75 }));
  soup.addRegion(cube());
  const Expected expected{ { { 1, 1. / 64 }, { 2, 7. / 64 }, { 3, 7. / 8 } },
    { { { 0, 3 }, 6 }, { { 2, 3 }, 1.5 }, { { 1, 2 }, 0.375 } } };
  expectExactly(soup, expected);
  expectNearly(soup, expected, 3e-5);
}

TEST(Regions, EndFlushWithEachOther)
{
  Soup soup;
  soup.addRegion(box({ 0.25, 0.25, 0 }, { 0.75, 0.75, 1 })); // a duct through the next
  soup.addRegion(cube());
  const Expected expected{ { { 1, 0.25 }, { 2, 0.75 } },
    { { { 0, 1 }, 0.5 }, { { 0, 2 }, 5.5 }, { { 1, 2 }, 2 } } };
  expectExactly(soup, expected);
  expectNearly(soup, expected, 3e-5);
}

TEST(Regions, MayTouchAtAPoint)
{
  Soup soup;
  soup.addRegion(octahedron(1).moved({ 0, 0, 1 }));
  soup.addRegion(box({ -1, -1, -1 }, { 1, 1, 0 }));
  const double area = soup.area() - 16;
  const Expected expected{ { { 1, 4. / 3 }, { 2, 4 } }, { { { 0, 1 }, area }, { { 0, 2 }, 16 } } };
  expectExactly(soup, expected);
}

// Where they touch in slanted walls, these have the same triangles.
TEST(Regions, MayBeTurned)
{
  Soup soup;
  soup.addRegion(cube());
  soup.addRegion(cube()
                   .each([](const Vector& p) {
                     return Vector{ 3 - 2 * p[0], p[1], p[2] };
                   })
                   .flipped());
  const std::vector<std::int32_t> regions = soup.region;
  soup = soup.turned();
  soup.region = regions;
  expectExactly(soup, OfTwoBoxes);
  expectNearly(soup, OfTwoBoxes, 3e-5);
}

TEST(Regions, MayBeSmooth)
{
  Soup soup;
  soup.addRegion(sphere(3, 0.375));
  soup.addRegion(sphere(3, 0.5));
  soup.addRegion(box({ -1, -1, -1 }, { 1, 1, 1 }));
  const double inner = sphere(3, 0.375).volume();
  const double outer = sphere(3, 0.5).volume();
  const Expected expected{ { { 1, inner }, { 2, outer - inner }, { 3, 8 - outer } },
    { { { 0, 3 }, 24 }, { { 1, 2 }, sphere(3, 0.375).area() },
      { { 2, 3 }, sphere(3, 0.5).area() } } };
  expectExactly(soup, expected);
  expectNearly(soup, expected, 0.1);
}

TEST(Regions, DoNotDependOnThreadsNorOnTheOrderOfTriangles)
{
  Soup soup;
  soup.addRegion(cube());
  soup.addRegion(box({ 1, 0.25, -0.5 }, { 2, 0.75, 0.625 }));
  soup.addRegion(sphere(2, 0.25).moved({ 0.5, 0.5, 1.5 }));
  TestOptions options;
  const GridSpec grid = cellsAlongLongest(soup, 9.3);
  const Meshed before = meshOf(soup, grid, options);
  std::mt19937 random(5);
  std::vector<std::size_t> order(soup.triangles.size());
  std::iota(order.begin(), order.end(), std::size_t(0));
  std::shuffle(order.begin(), order.end(), random);
  Soup other = soup;
  for (std::size_t i = 0; i < order.size(); ++i)
  {
    other.triangles[i] = soup.triangles[order[i]];
    other.region[i] = soup.region[order[i]];
    other.boundary[i] = soup.boundary[order[i]];
    std::rotate(
      other.triangles[i].begin(), other.triangles[i].begin() + i % 3, other.triangles[i].end());
  }
  options.threads = 3;
  EXPECT_TRUE(meshOf(other, grid, options).mesh == before.mesh);
}

TEST(Regions, MustBeClosed)
{
  Soup soup;
  soup.addRegion(cube());
  Soup open = box({ 2, 0, 0 }, { 3, 1, 1 });
  open.triangles.pop_back();
  open.boundary.pop_back();
  soup.addRegion(open);
  expectRefusal(soup, "The surface of region 2 is not closed at (");
}

TEST(Regions, MustNotPassThroughEachOther)
{
  Soup soup;
  soup.addRegion(cube());
  soup.addRegion(box({ 0.5, 0.25, 0.25 }, { 2, 0.75, 0.75 }));
  expectRefusal(soup, "The surfaces of regions 1 and 2 pass through each other near (");
}

TEST(Regions, TheFirstKeepsTheVolume)
{
  Soup soup;
  soup.addRegion(cube());
  soup.addRegion(box({ 0.3, 0.2, 0.4 }, { 0.7, 0.8, 0.6 }));
  expectRefusal(soup, "Nothing is left of region 2");
}
