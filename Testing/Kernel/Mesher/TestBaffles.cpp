// Open sheets that divide their region: both their sides are boundaries, and nothing else changes.
#include "Support/MeshChecker.h"

#include <gtest/gtest.h>

using namespace cartesian;

namespace
{

constexpr std::int32_t Front = 10; // boundaries of baffles
constexpr std::int32_t Back = 11;

// The quadrangle abcd as a sheet of a region.
void addSheet(Soup& soup, const std::array<Vector, 4>& corners, std::int32_t region = FirstRegion)
{
  const auto first = static_cast<std::uint32_t>(soup.points.size());
  soup.points.insert(soup.points.end(), corners.begin(), corners.end());
  soup.boundary.resize(soup.triangles.size(), 0);
  for (const std::array<std::uint32_t, 3>& t :
    { std::array<std::uint32_t, 3>{ 0, 1, 2 }, std::array<std::uint32_t, 3>{ 0, 2, 3 } })
  {
    soup.triangles.push_back({ first + t[0], first + t[1], first + t[2] });
    soup.boundary.push_back(Front);
    if (!soup.region.empty())
    {
      soup.region.push_back(region);
    }
  }
}

// A duct of 3 x 1 x 1 with a sheet across it that leans by `lean`.
Soup duct(double lean)
{
  Soup soup = box({ 0, 0, 0 }, { 3, 1, 1 });
  addSheet(soup,
    { Vector{ 1.3, 0, 0 }, { 1.3 + lean, 1, 0 }, { 1.3 + 1.5 * lean, 1, 1 },
      { 1.3 + lean / 2, 0, 1 } });
  return soup;
}

TestOptions withBaffle(TestOptions options)
{
  options.patches = exactFit();
  options.baffles = { { Front, Back } };
  return options;
}

std::map<std::int32_t, double> areasOf(const MeshArrays& mesh)
{
  std::map<std::int32_t, double> areas;
  for (std::size_t f = 0; f < mesh.boundaryIndex.size(); ++f)
  {
    const auto corner = [&](Id i) {
      const auto p = 3 *
        static_cast<std::size_t>(
          mesh.boundaryPoints[static_cast<std::size_t>(mesh.boundaryStart[f] + i)]);
      return Vector{ mesh.points[p], mesh.points[p + 1], mesh.points[p + 2] };
    };
    Vector sum{};
    for (Id i = 1; i + 1 < mesh.boundaryStart[f + 1] - mesh.boundaryStart[f]; ++i)
    {
      sum = plus(sum, cross(minus(corner(i), corner(0)), minus(corner(i + 1), corner(0))));
    }
    areas[mesh.boundaryIndex[f]] += norm(sum) / 2;
  }
  return areas;
}

void expectDivided(const Soup& soup, double volume, double area, double tolerance = 0)
{
  for (const double cells : { 1.0, 3.7, 11.3 })
  {
    for (TestOptions options : { withBaffle(asTheyAre()), withBaffle({}) })
    {
      SCOPED_TRACE(std::to_string(cells) + " cells along the longest dimension");
      options.contactTolerance = tolerance;
      const Meshed meshed = meshOf(soup, cellsAlongLongest(soup, cells), options);
      EXPECT_TRUE(isValid(meshed.mesh, true));
      EXPECT_EQ(volumesByRegion(meshed.mesh).size(), 1U);
      EXPECT_NEAR(volumeOf(meshed.mesh), volume, 1e-8 * volume);
      std::map<std::int32_t, double> areas = areasOf(meshed.mesh);
      EXPECT_NEAR(areas[Front], area, 1e-8);
      EXPECT_NEAR(areas[Back], area, 1e-8);
    }
  }
}

double sheetArea(const Soup& soup);

// Baffles that do not divide their region, or could not: two sides, a little apart.
void expectThin(const Soup& soup, double volume, const TestOptions& given)
{
  const bool isExact = given.layers.count == 0;
  TestOptions options = given;
  options.baffles = { { Front, Back } };
  options.patches = isExact ? exactFit() : PatchSpec();
  for (const double cells : { 3.7, 11.3 })
  {
    SCOPED_TRACE(std::to_string(cells) + " cells along the longest dimension");
    const Meshed meshed = meshOf(soup, cellsAlongLongest(soup, cells), options);
    EXPECT_TRUE(isValid(meshed.mesh, true));
    EXPECT_NEAR(volumeOf(meshed.mesh), volume, (isExact ? 1e-6 : 1e-4) * volume);
    const double area = sheetArea(soup);
    std::map<std::int32_t, double> areas = areasOf(meshed.mesh);
    EXPECT_NEAR(areas[Front], area, (isExact ? 5e-3 : 0.05) * area);
    EXPECT_NEAR(areas[Back], area, (isExact ? 5e-3 : 0.05) * area);
  }
}

double sheetArea(const Soup& soup)
{
  double area = 0;
  for (std::size_t t = 0; t < soup.triangles.size(); ++t)
  {
    area += soup.boundary[t] == Front ? soup.area(t) : 0;
  }
  return area;
}

}

TEST(Baffles, AcrossADuct)
{
  for (const double lean : { 0.0, 0.4 })
  {
    SCOPED_TRACE(lean);
    expectDivided(duct(lean), 3, sheetArea(duct(lean)));
    expectDivided(duct(lean).turned(), 3, sheetArea(duct(lean)));
  }
}

// Its rim has none of the ball's edges, and is up to 0.02 away from them.
TEST(Baffles, AcrossABall)
{
  constexpr int Corners = 20;
  Soup ball = sphere(6, 1).turned();
  const double volume = ball.volume();
  ball.boundary.assign(ball.triangles.size(), 0);
  const auto first = static_cast<std::uint32_t>(ball.points.size());
  ball.points.push_back({ 0, 0, 0.1 });
  for (std::uint32_t i = 0; i < Corners; ++i)
  {
    const double angle = 2 * Pi * i / Corners;
    ball.points.push_back({ 0.99 * std::cos(angle), 0.99 * std::sin(angle), 0.1 });
    ball.triangles.push_back({ first, first + 1 + i, first + 1 + (i + 1) % Corners });
    ball.boundary.push_back(Front);
  }
  for (const double cells : { 3.7, 11.3 })
  {
    TestOptions options = withBaffle({});
    options.contactTolerance = 0.02;
    const Meshed meshed = meshOf(ball, cellsAlongLongest(ball, cells), options);
    EXPECT_TRUE(isValid(meshed.mesh, true));
    EXPECT_NEAR(volumeOf(meshed.mesh), volume, 1e-8);
    std::map<std::int32_t, double> areas = areasOf(meshed.mesh);
    EXPECT_NEAR(areas[Front], Pi * (1 - 0.01), 0.03 * Pi);
    EXPECT_NEAR(areas[Front], areas[Back], 1e-9);
  }
}

// A wall in the middle of one part of the duct: three parts along one edge.
TEST(Baffles, MayMeet)
{
  Soup soup = box({ 0, 0, 0 }, { 3, 1, 1 });
  addSheet(soup, { Vector{ 1.3, 0, 0 }, { 1.3, 0.45, 0 }, { 1.3, 0.45, 1 }, { 1.3, 0, 1 } });
  addSheet(soup, { Vector{ 1.3, 0.45, 0 }, { 1.3, 1, 0 }, { 1.3, 1, 1 }, { 1.3, 0.45, 1 } });
  addSheet(soup, { Vector{ 0, 0.45, 0 }, { 1.3, 0.45, 0 }, { 1.3, 0.45, 1 }, { 0, 0.45, 1 } });
  expectDivided(soup, 3, 1 + 1.3);
}

TEST(Baffles, LeaveCavitiesAndOtherBodiesAlone)
{
  Soup soup = box({ 0, 0, 0 }, { 3, 1, 1 });
  soup.add(box({ 2, 0.4, 0.4 }, { 2.2, 0.6, 0.6 }).flipped());
  soup.add(box({ 0.4, 0.3, 0.4 }, { 0.6, 0.7, 0.6 }).flipped());
  soup.add(box({ 4, 0, 0 }, { 5, 1, 1 }));
  addSheet(soup, { Vector{ 1.3, 0, 0 }, { 1.4, 1, 0 }, { 1.4, 1, 1 }, { 1.3, 0, 1 } });
  expectDivided(soup, 4 - 0.008 - 0.016, sheetArea(soup));
}

TEST(Baffles, DivideOneOfTwoRegions)
{
  Soup soup;
  soup.addRegion(box({ 3, 0, 0 }, { 4, 1, 1 }));
  soup.addRegion(box({ 0, 0, 0 }, { 3, 1, 1 }));
  addSheet(
    soup, { Vector{ 1.3, 0, 0 }, { 1.4, 1, 0 }, { 1.4, 1, 1 }, { 1.3, 0, 1 } }, FirstRegion + 1);
  const Meshed meshed = meshOf(soup, cellsAlongLongest(soup, 11.3), withBaffle({}));
  EXPECT_TRUE(isValid(meshed.mesh, true));
  const std::map<int, double> volumes = volumesByRegion(meshed.mesh);
  ASSERT_EQ(volumes.size(), 2U);
  EXPECT_NEAR(volumes.at(1), 1, 1e-8);
  EXPECT_NEAR(volumes.at(2), 3, 1e-8);
  EXPECT_NEAR(areasBetweenRegions(meshed.mesh).at({ 1, 2 }), 1, 1e-8);
  EXPECT_NEAR(areasOf(meshed.mesh).at(Front), sheetArea(soup), 1e-8);
}

TEST(Baffles, DoNotDependOnThreads)
{
  const Soup soup = duct(0.4).turned();
  TestOptions options = withBaffle({});
  const Meshed one = meshOf(soup, cellsAlongLongest(soup, 11.3), options);
  options.threads = 3;
  EXPECT_TRUE(meshOf(soup, cellsAlongLongest(soup, 11.3), options).mesh == one.mesh);
}

// One can go around it: each side is a wall all the same.
TEST(Baffles, NeedNotDivide)
{
  const double third = 1.0 / 3;
  const Soup ring =
    voxels({ std::vector<double>{ 0, third, 2 * third, 1 }, { 0, third, 2 * third, 1 }, { 0, 1 } },
      [](int i, int j, int) { return i != 1 || j != 1; });
  Soup soup = ring;
  addSheet(soup, { Vector{ 0, 0.5, 0 }, { third, 0.5, 0 }, { third, 0.5, 1 }, { 0, 0.5, 1 } });
  expectThin(soup, 1 - third * third, {});
}

TEST(Baffles, MayEndInside)
{
  Soup half = box({ 0, 0, 0 }, { 3, 1, 1 });
  addSheet(half, { Vector{ 1.3, 0, 0 }, { 1.3, 1, 0 }, { 1.3, 1, 0.5 }, { 1.3, 0, 0.5 } });
  expectThin(half, 3, {});
  Soup alone = box({ 0, 0, 0 }, { 3, 1, 1 });
  addSheet(
    alone, { Vector{ 1.3, 0.2, 0.2 }, { 1.3, 0.8, 0.2 }, { 1.3, 0.8, 0.5 }, { 1.3, 0.2, 0.5 } });
  expectThin(alone, 3, {});
}

// The mesh's first cells at a baffle, too.
TEST(Baffles, MayCarryLayers)
{
  TestOptions options;
  options.layers.count = 2;
  expectThin(duct(0.4), 3, options);
}

// A fin on a body, there once, whose lower rim is 0.001 above it.
TEST(Baffles, StandOnBodiesOutside)
{
  Soup soup = box({ 0, 0, 0 }, { 1, 1, 0.3 });
  addSheet(
    soup, { Vector{ 0.1, 0.5, 0.301 }, { 0.9, 0.5, 0.301 }, { 0.9, 0.6, 0.9 }, { 0.1, 0.6, 0.9 } });
  TestOptions options;
  options.contactTolerance = 0.002;
  options.domain.domain = Domain::Outside;
  options.domain.boxFrom = BoxSource::Bounds;
  options.domain.bounds = { { -1, -1, -1 }, { 2, 2, 2 } };
  options.domain.sides = { 20, 21, 22, 23, 24, 25 };
  expectThin(soup, 27 - 0.3, options);
}
