// Patches of surfaces of which they are known.
#include "Support/DataFile.h"
#include "Support/Shapes.h"
#include "Surface/SurfaceSplit.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <map>
#include <numeric>
#include <random>
#include <set>

using namespace cartesian;

namespace
{

SurfaceSplit split(const Soup& soup, SplitBy by, int threads = 1)
{
  Execution execution(threads);
  return splitSurface(soup.view(), { by, 30 }, execution);
}

Soup oneBoundary(Soup soup)
{
  soup.boundary.clear();
  return soup;
}

Soup duct(double length)
{
  return oneBoundary(box({ 0, 0, 0 }, { length, 1, 1 }));
}

// A tube of `n` sides along x, with flat ends; the solid, or what it encloses.
Soup tube(int n, double radius, double length)
{
  Soup soup;
  for (const double x : { 0.0, length })
  {
    for (int i = 0; i < n; ++i)
    {
      const double angle = 2 * Pi * i / n;
      soup.points.push_back({ x, radius * std::cos(angle), radius * std::sin(angle) });
    }
  }
  const auto at = [n](int end, int i) { return static_cast<std::uint32_t>(end * n + i % n); };
  for (int i = 0; i < n; ++i)
  {
    soup.triangles.push_back({ at(0, i), at(1, i + 1), at(1, i) });
    soup.triangles.push_back({ at(0, i), at(0, i + 1), at(1, i + 1) });
    if (i > 0 && i + 1 < n)
    {
      soup.triangles.push_back({ at(0, 0), at(0, i + 1), at(0, i) });
      soup.triangles.push_back({ at(1, 0), at(1, i), at(1, i + 1) });
    }
  }
  return soup;
}

std::vector<double> areas(const SurfaceSplit& split, bool ofThoseAlone)
{
  std::vector<double> result;
  for (const SurfacePatch& patch : split.patches)
  {
    if (patch.standsAlone == ofThoseAlone)
    {
      result.push_back(patch.area);
    }
  }
  return result;
}

}

TEST(SurfaceSplit, OfACubeByItsEdgesGivesItsSides)
{
  for (const SplitBy by : { SplitBy::FeatureAngle, SplitBy::FlatCaps, SplitBy::Planes })
  {
    const SurfaceSplit sides = split(oneBoundary(cube()), by);
    ASSERT_EQ(sides.patches.size(), 6u);
    for (const SurfacePatch& patch : sides.patches)
    {
      EXPECT_DOUBLE_EQ(patch.area, 1);
      EXPECT_EQ(patch.triangles, 2u);
    }
  }
  EXPECT_EQ(split(oneBoundary(cube()), SplitBy::ConnectedParts).patches.size(), 1u);
}

TEST(SurfaceSplit, CapsOfADuctAreItsEnds)
{
  const SurfaceSplit ends = split(duct(5), SplitBy::FlatCaps);
  EXPECT_EQ(areas(ends, true), (std::vector<double>{ 1, 1 }));
  EXPECT_EQ(areas(ends, false), (std::vector<double>{ 20 }));
  EXPECT_LT(ends.patches[0].centre[0], ends.patches[1].centre[0]);
}

TEST(SurfaceSplit, CapsAreTheSameOfASurfaceThatIsInsideOutTurnedOrMoved)
{
  const Soup straight = tube(24, 1, 6);
  for (const Soup& soup : { straight, straight.flipped(), straight.turned(),
         straight.moved({ 1000, 0, 0 }), straight.permuted({ 2, 0, 1 }), straight.scaled(1e-3) })
  {
    const SurfaceSplit ends = split(soup, SplitBy::FlatCaps);
    EXPECT_EQ(areas(ends, true).size(), 2u);
    EXPECT_EQ(areas(ends, false).size(), 1u);
  }
}

// Walls of thin triangles, with other points at either end.
TEST(SurfaceSplit, CapsOfALongTubeAreItsEnds)
{
  const Soup tube = oneBoundary(tubeWithEnds(12, 6, 30));
  for (const double size : { 0.1, 1.0, 30.0 })
  {
    for (const Soup& soup : { tube, tube.turned(0, 20), tube.turned(), tube.permuted({ 2, 0, 1 }) })
    {
      const SurfaceSplit ends = split(soup.scaled(size), SplitBy::FlatCaps);
      std::vector<double> caps = areas(ends, true);
      std::sort(caps.begin(), caps.end());
      ASSERT_EQ(caps.size(), 2u);
      EXPECT_NEAR(caps[0], 1.5 * std::sqrt(3.0) * size * size, 1e-6 * size * size);
      EXPECT_NEAR(caps[1], 3 * size * size, 1e-6 * size * size);
      EXPECT_EQ(areas(ends, false).size(), 1u);
    }
  }
}

TEST(SurfaceSplit, AFlatWallThatADuctBeginsAtIsNoCap)
{
  // A plenum from which a duct leads: its wall around the duct turns outwards there.
  const std::array<std::vector<double>, 3> lines{ { { 0, 4, 12 }, { 0, 1.5, 2.5, 4 },
    { 0, 1.5, 2.5, 4 } } };
  Soup soup = voxels(lines, [](int i, int j, int k) { return i == 0 || (j == 1 && k == 1); });
  soup.boundary.clear();
  const SurfaceSplit found = split(soup, SplitBy::FlatCaps);
  const std::vector<double> caps = areas(found, true);
  EXPECT_DOUBLE_EQ(*std::min_element(caps.begin(), caps.end()), 1); // the duct's end
  for (const SurfacePatch& patch : found.patches)
  {
    EXPECT_FALSE(patch.standsAlone && std::abs(patch.area - 15) < 1e-9);
  }
}

TEST(SurfaceSplit, RoundBodiesHaveNoCaps)
{
  for (const Soup& soup : { sphere(6, 1), torus(24, 2, 0.5), bumpySphere(3, 8) })
  {
    EXPECT_TRUE(areas(split(oneBoundary(soup), SplitBy::FlatCaps), true).empty());
  }
}

TEST(SurfaceSplit, AMitredEndIsACap)
{
  const Soup soup = tube(32, 1, 8).each([](const Vector& p) -> Vector {
    return { p[0] > 4 ? p[0] + 0.9 * p[1] : p[0], p[1], p[2] };
  });
  EXPECT_EQ(areas(split(soup, SplitBy::FlatCaps), true).size(), 2u);
}

TEST(SurfaceSplit, PlanesUniteWhatLiesInOne)
{
  // Feet of one table stand in one plane.
  const std::array<std::vector<double>, 3> lines{ { { 0, 1, 3, 4 }, { 0, 1 }, { 0, 1, 2 } } };
  Soup soup = voxels(lines, [](int i, int, int k) { return k == 1 || i != 1; });
  soup.boundary.clear();
  const std::vector<double> found = areas(split(soup, SplitBy::Planes), true);
  // Both feet; the outer sides; the underside between the feet.
  EXPECT_EQ(std::count(found.begin(), found.end(), 2.0), 4);
  EXPECT_DOUBLE_EQ(std::accumulate(found.begin(), found.end(), 0.0), soup.area());
}

TEST(SurfaceSplit, ConnectedPartsHaveNoCommonEdge)
{
  EXPECT_EQ(split(oneBoundary(nestedSpheres()), SplitBy::ConnectedParts).patches.size(), 2u);
  Soup touching = oneBoundary(cube());
  touching.add(oneBoundary(cube().moved({ 1, 1, 1 })));
  EXPECT_EQ(split(touching, SplitBy::ConnectedParts).patches.size(), 2u);
}

TEST(SurfaceSplit, NoPatchHasTwoBoundaries)
{
  for (const NamedShape& shape : cleanShapes())
  {
    for (int by = 0; by <= static_cast<int>(SplitBy::Boundaries); ++by)
    {
      const SurfaceSplit found = split(shape.soup, static_cast<SplitBy>(by));
      double area = 0;
      for (const SurfacePatch& patch : found.patches)
      {
        area += patch.area;
        EXPECT_GT(patch.triangles, 0u);
      }
      EXPECT_NEAR(area, shape.soup.area(), 1e-12 * shape.soup.area()) << shape.name;
      for (std::size_t t = 0; t < shape.soup.triangles.size(); ++t)
      {
        EXPECT_EQ(found.patches[found.patchOf[t]].boundary, shape.soup.boundaryOf(t));
      }
    }
  }
}

TEST(SurfaceSplit, DependsNeitherOnTheOrderOfTrianglesNorOnThreads)
{
  std::mt19937 random(7);
  for (const NamedShape& shape : cleanShapes())
  {
    std::vector<std::uint32_t> order(shape.soup.triangles.size());
    std::iota(order.begin(), order.end(), 0);
    std::shuffle(order.begin(), order.end(), random);
    Soup shuffled = shape.soup;
    for (std::size_t t = 0; t < order.size(); ++t)
    {
      shuffled.triangles[t] = shape.soup.triangles[order[t]];
      if (!shuffled.boundary.empty())
      {
        shuffled.boundary[t] = shape.soup.boundary[order[t]];
      }
    }
    const SurfaceSplit first = split(shape.soup, SplitBy::FlatCaps);
    const SurfaceSplit second = split(shuffled, SplitBy::FlatCaps, 3);
    for (std::size_t t = 0; t < order.size(); ++t)
    {
      ASSERT_EQ(second.patchOf[t], first.patchOf[order[t]]) << shape.name;
    }
  }
}

TEST(SurfaceSplit, TrianglesWithoutAreaEndNoPatch)
{
  Soup soup = oneBoundary(box({ 0, 0, 0 }, { 5, 1, 1 }));
  const std::size_t sound = soup.triangles.size();
  soup.triangles.push_back({ soup.triangles[0][0], soup.triangles[0][0], soup.triangles[0][1] });
  const SurfaceSplit found = split(soup, SplitBy::FlatCaps);
  EXPECT_EQ(found.patches.size(), 3u);
  EXPECT_EQ(found.patchOf.size(), sound + 1);
}

TEST(SurfaceSplit, CapsOfTheHeaderAreItsInletsAndOutlets)
{
  const NamedShape header = readData("kcl_exhaust_header_lumens.stl");
  const SurfaceSplit known = split(header.soup, SplitBy::Boundaries);
  const SurfaceSplit found = split(oneBoundary(header.soup), SplitBy::FlatCaps);
  ASSERT_EQ(found.patches.size(), 9u);
  std::map<std::uint32_t, std::set<std::int32_t>> boundaries; // of each cap
  std::map<std::uint32_t, double> area;
  for (std::size_t t = 0; t < found.patchOf.size(); ++t)
  {
    if (found.patches[found.patchOf[t]].standsAlone)
    {
      boundaries[found.patchOf[t]].insert(header.soup.boundaryOf(t));
    }
  }
  ASSERT_EQ(boundaries.size(), 8u);
  for (const auto& [cap, ofIt] : boundaries)
  {
    ASSERT_EQ(ofIt.size(), 1u);
    const auto same = std::find_if(known.patches.begin(), known.patches.end(),
      [b = *ofIt.begin()](const SurfacePatch& patch) { return patch.boundary == b; });
    EXPECT_EQ(same->triangles, found.patches[cap].triangles);
    EXPECT_NEAR(same->area, found.patches[cap].area, 1e-9 * same->area);
  }
}
