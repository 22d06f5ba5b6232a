// Duplicates and holes: what is dropped, what is closed, and the resulting mesh.
#include "Support/Effort.h"
#include "Support/MeshChecker.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

using namespace cartesian;

namespace
{

Soup unmarked(Soup soup)
{
  soup.boundary.clear();
  return soup;
}

// Without the triangles for whose centroids `lost` is true.
Soup without(const Soup& soup, const std::function<bool(const Vector&)>& lost)
{
  Soup rest;
  rest.points = soup.points;
  for (std::size_t t = 0; t < soup.triangles.size(); ++t)
  {
    Vector middle{};
    for (const std::uint32_t p : soup.triangles[t])
    {
      for (int axis = 0; axis < 3; ++axis)
      {
        middle[axis] += soup.points[p][axis] / 3;
      }
    }
    if (!lost(middle))
    {
      rest.triangles.push_back(soup.triangles[t]);
      rest.boundary.push_back(soup.boundaryOf(t));
    }
  }
  return rest;
}

Soup without(Soup soup, std::size_t triangle)
{
  soup.triangles.erase(soup.triangles.begin() + static_cast<std::ptrdiff_t>(triangle));
  if (!soup.boundary.empty())
  {
    soup.boundary.erase(soup.boundary.begin() + static_cast<std::ptrdiff_t>(triangle));
  }
  return soup;
}

bool closed(const Surface& surface)
{
  Execution execution;
  return check(SurfaceEdges(surface, execution), execution).oriented();
}

using Volumes = std::map<std::array<int, 3>, std::vector<double>>;

// The same cell by cell; faces may begin at another corner, which changes the rounding of volumes.
void expectSame(const Volumes& found, const Volumes& wanted)
{
  ASSERT_EQ(found.size(), wanted.size());
  for (auto a = found.begin(), b = wanted.begin(); a != found.end(); ++a, ++b)
  {
    ASSERT_EQ(a->first, b->first);
    ASSERT_EQ(a->second.size(), b->second.size());
    for (std::size_t i = 0; i < a->second.size(); ++i)
    {
      EXPECT_NEAR(a->second[i] / b->second[i], 1, 1e-12);
    }
  }
}

}

class OneMissing : public ::testing::TestWithParam<NamedShape>
{
};

// A missing triangle, any of any shape, is restored, with its boundary if it is smaller than a box.
TEST_P(OneMissing, ChangesNothing)
{
  const Soup& soup = GetParam().soup;
  const GridSpec grid = cellsAlongLongest(soup, 12.3);
  const Volumes whole = volumesByBox(meshOf(soup, grid).mesh);
  const std::size_t count = soup.triangles.size();
  for (std::size_t n = 0; n < std::min<std::size_t>(count, 6); ++n)
  {
    const std::size_t triangle = n * count / std::min<std::size_t>(count, 6);
    SCOPED_TRACE("without triangle " + std::to_string(triangle));
    const Meshed meshed = meshOf(without(soup, triangle), grid);
    EXPECT_TRUE(isValid(meshed.mesh));
    expectSame(volumesByBox(meshed.mesh), whole);
    ASSERT_EQ(meshed.prepared.repair.holes.size(), 1U);
    const Hole& hole = meshed.prepared.repair.holes[0];
    EXPECT_EQ(hole.triangles, 1U);
    EXPECT_EQ(hole.leak, meshed.prepared.surface.boundary.back() == NoBoundary);
  }
}

INSTANTIATE_TEST_SUITE_P(Clean, OneMissing, ::testing::ValuesIn(cleanShapes()), nameOf);

TEST(Duplicates, AreDroppedWhicheverWayTheyFace)
{
  const Soup soup = unmarked(sphere(6, 1));
  Soup twice = soup;
  for (std::size_t t = 0; t < soup.triangles.size(); t += 3)
  {
    std::array<std::uint32_t, 3> copy = soup.triangles[t];
    if (t % 2 == 0)
    {
      std::swap(copy[0], copy[1]);
    }
    twice.triangles.insert(twice.triangles.begin() + static_cast<std::ptrdiff_t>(2 * t / 3), copy);
  }
  const GridSpec grid = cellsAlongLongest(soup, 8.7);
  const Meshed meshed = meshOf(twice, grid);
  EXPECT_EQ(
    meshed.prepared.repair.duplicates.size(), twice.triangles.size() - soup.triangles.size());
  EXPECT_TRUE(closed(meshed.prepared.surface));
  expectSame(volumesByBox(meshed.mesh), volumesByBox(meshOf(soup, grid).mesh));
}

TEST(Duplicates, ABodyManyTimesIsOne)
{
  const Soup soup = unmarked(sphere(4, 1));
  Soup thrice = soup;
  thrice.add(soup.flipped()).add(soup);
  thrice.boundary.clear();
  const Meshed meshed = meshOf(thrice, cellsOf(0.3));
  EXPECT_EQ(meshed.prepared.repair.duplicates.size(), 2 * soup.triangles.size());
  EXPECT_TRUE(fills(meshed.mesh, soup));
}

TEST(Duplicates, AWallBetweenBodiesIsNone)
{
  const Soup both = unmarked(cube().add(cube().moved({ 1, 0, 0 })));
  const Meshed meshed = meshOf(both, cellsOf(0.3));
  EXPECT_EQ(meshed.prepared.repair.duplicates.size(), 4U);
  EXPECT_TRUE(meshed.flawedBoxes.empty());
  EXPECT_TRUE(fills(meshed.mesh, unmarked(box({ 0, 0, 0 }, { 2, 1, 1 }))));
}

// A tetrahedron twice as high as another on the same triangle: both as given are one body.
TEST(Duplicates, AWallOfTwoBodiesThatOverlapStays)
{
  const auto onTheFloor = [](const Vector& apex) {
    return unmarked(tetrahedron({ { { 0, 0, 0 }, { 1, 0, 0 }, { 0, 1, 0 }, apex } })).turned();
  };
  const Soup high = onTheFloor({ 0.3, 0.3, 1 });
  Soup both = high;
  both.add(onTheFloor({ 0.3, 0.4, 0.5 }));
  const Meshed meshed = meshOf(both, cellsOf(0.05));
  EXPECT_TRUE(meshed.prepared.repair.duplicates.empty());
  EXPECT_TRUE(meshed.prepared.surface.byParity.empty());
  EXPECT_TRUE(isValid(meshed.mesh));
  EXPECT_NEAR(volumeOf(meshed.mesh) / high.volume(), 1, 0.05);
}

TEST(Duplicates, TheLowestBoundaryStays)
{
  Soup soup = cube();
  soup.triangles.push_back(soup.triangles[11]); // boundary 5
  soup.boundary.push_back(3);
  const Surface surface = prepare(soup, cellsOf(0.3)).surface;
  for (std::size_t t = 0; t < surface.triangles.size(); ++t)
  {
    EXPECT_EQ(namesAVertexTwice(surface.triangles[t]), surface.given[t] == 11);
  }
}

// Two halves of a sphere that do not quite meet: each is closed by a lid.
TEST(Holes, WiderThanABoxAreLeaks)
{
  const Soup soup = unmarked(sphere(8, 1));
  Soup halves;
  for (const bool upper : { false, true })
  {
    const Soup half = without(soup, [&](const Vector& middle) { return (middle[2] > 0) != upper; });
    halves.add(half.moved({ 0, 0, upper ? 0.5 : 0 }));
  }
  const Meshed meshed = meshOf(halves, cellsOf(0.15));
  EXPECT_EQ(meshed.prepared.repair.holes.size(), 2U);
  EXPECT_EQ(meshed.prepared.repair.leaks(), 2U);
  EXPECT_TRUE(isValid(meshed.mesh));
  EXPECT_TRUE(meshed.flawedBoxes.empty());
  EXPECT_NEAR(volumeOf(meshed.mesh), soup.volume(), 1e-6);
  const auto& boundary = meshed.mesh.boundaryIndex;
  EXPECT_GT(std::count(boundary.begin(), boundary.end(), NoBoundary), 2 * 100);
  const std::string text =
    describeFlaws(meshed.prepared, std::vector<Id>(halves.triangles.size()), {});
  EXPECT_NE(text.find("2 holes are wider than a box"), std::string::npos) << text;
}

// A rim with more edges than are filled without shortening it.
TEST(Holes, OfManyEdges)
{
  const Soup soup = unmarked(sphere(60, 1));
  const Soup half = without(soup, [](const Vector& middle) { return middle[2] > 0; });
  const PreparedSurface prepared = prepare(half, cellsOf(0.5));
  ASSERT_EQ(prepared.repair.holes.size(), 1U);
  EXPECT_GT(prepared.repair.holes[0].rim.size(), 128U);
  EXPECT_EQ(prepared.repair.holes[0].triangles, prepared.repair.holes[0].rim.size() - 2);
  EXPECT_NEAR(prepared.repair.holes[0].width * prepared.surface.lattice.step(), 2, 0.01);
  EXPECT_TRUE(closed(prepared.surface));
  EXPECT_NEAR(volumeOf(prepared.surface), soup.volume() / 2, 1e-6);
}

// A slit from pole to pole.
TEST(Holes, ACrackIsZippedUp)
{
  Soup soup = unmarked(sphere(8, 1));
  const std::size_t count = soup.points.size();
  for (std::size_t p = 0; p < count; ++p)
  {
    if (std::abs(soup.points[p][1]) < 1e-9 && soup.points[p][0] > 0.2)
    {
      // Triangles on the left get points of their own, a little aside.
      const auto copy = static_cast<std::uint32_t>(soup.points.size());
      soup.points.push_back({ soup.points[p][0], -4e-3, soup.points[p][2] });
      for (auto& triangle : soup.triangles)
      {
        double y = 0;
        for (const std::uint32_t corner : triangle)
        {
          y += soup.points[corner][1];
        }
        for (std::uint32_t& corner : triangle)
        {
          corner = corner == p && y < 0 ? copy : corner;
        }
      }
    }
  }
  ASSERT_GT(soup.points.size(), count + 3);
  const Meshed meshed = meshOf(soup, cellsOf(0.15));
  ASSERT_EQ(meshed.prepared.repair.holes.size(), 1U);
  EXPECT_FALSE(meshed.prepared.repair.holes[0].leak);
  EXPECT_TRUE(closed(meshed.prepared.surface));
  EXPECT_TRUE(meshed.flawedBoxes.empty());
  EXPECT_NEAR(volumeOf(meshed.mesh), sphere(8, 1).volume(), 1e-3);
}

TEST(Holes, WidthIsThatOfACircleOrASquare)
{
  Soup lid = unmarked(cube());
  lid.triangles.resize(10);
  const PreparedSurface open = prepare(lid, cellsOf(0.3));
  ASSERT_EQ(open.repair.holes.size(), 1U);
  EXPECT_EQ(open.repair.holes[0].rim.size(), 4U);
  EXPECT_NEAR(open.repair.holes[0].width * open.surface.lattice.step(), 1, 1e-6);
  EXPECT_TRUE(open.repair.holes[0].leak);
  EXPECT_FALSE(prepare(lid, cellsOf(1.01)).repair.holes[0].leak);
  EXPECT_NEAR(volumeOf(open.surface), 1, 1e-6);
}

TEST(Holes, TakeTheBoundaryAroundThem)
{
  Soup soup = cube().turned();
  soup.triangles.erase(soup.triangles.begin() + 4);
  soup.boundary.erase(soup.boundary.begin() + 4); // one of two triangles of boundary 2
  const PreparedSurface prepared = prepare(soup, cellsOf(5));
  ASSERT_EQ(prepared.surface.triangles.size(), 12U);
  ASSERT_EQ(prepared.trianglesGiven(), 11U);
  const std::int32_t boundary = prepared.surface.boundary.back();
  EXPECT_TRUE(std::count(soup.boundary.begin(), soup.boundary.end(), boundary));
}

// Missing triangles that share only a corner leave two holes, not one.
TEST(Holes, ThatTouchAreTwo)
{
  const Soup soup = unmarked(octahedron(1));
  const auto& first = soup.triangles[0];
  std::size_t second = 1;
  const auto common = [&](std::size_t t) {
    return std::count_if(first.begin(), first.end(), [&](std::uint32_t p) {
      return std::count(soup.triangles[t].begin(), soup.triangles[t].end(), p) > 0;
    });
  };
  while (common(second) != 1)
  {
    ++second;
  }
  const PreparedSurface prepared = prepare(without(without(soup, second), 0), cellsOf(3));
  EXPECT_EQ(prepared.repair.holes.size(), 2U);
  EXPECT_TRUE(closed(prepared.surface));
  EXPECT_NEAR(volumeOf(prepared.surface), soup.volume(), 1e-8);
}

// One in a hundred triangles is missing, flipped or duplicated: the volume is within 1 % at 1/25.
TEST(Flawed, AtRandomKeepsTheVolume)
{
  const Soup soups[] = { unmarked(sphere(20, 1)), unmarked(bumpySphere(3, 16)),
    unmarked(torus(40, 1, 0.4)), unmarked(blockWithTubes()) };
  for (const Soup& soup : soups)
  {
    for (const unsigned seed : { 11U })
    {
      for (const char* kind : cases({ "missing", "flipped", "twice" }))
      {
        SCOPED_TRACE(kind + std::string(" of ") + std::to_string(soup.triangles.size()) +
          " triangles, seed " + std::to_string(seed));
        Soup flawed = soup;
        std::mt19937 random(seed);
        for (std::size_t n = soup.triangles.size() / 100 + 1; n > 0; --n)
        {
          const std::size_t t = random() % flawed.triangles.size();
          if (kind[0] == 'm')
          {
            flawed = without(flawed, t);
          }
          else if (kind[0] == 'f')
          {
            std::swap(flawed.triangles[t][0], flawed.triangles[t][1]);
          }
          else
          {
            flawed.triangles.push_back(flawed.triangles[t]);
          }
        }
        const MeshArrays mesh = meshOf(flawed, cellsAlongLongest(soup, 25)).mesh;
        EXPECT_TRUE(isValid(mesh));
        EXPECT_NEAR(volumeOf(mesh) / soup.volume(), 1, 0.01);
      }
    }
  }
}
