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
  for (const auto& [regions, area] : areas)
  {
    if (expected.areas.count(regions) == 0) // a tip that the grid cuts off: as small as the lattice
    {
      EXPECT_LT(area, 20 * mesh.step) << regions.first << " and " << regions.second;
    }
  }
  for (const auto& [regions, area] : expected.areas)
  {
    EXPECT_NEAR(areas.at(regions), area, slackOf(area))
      << "between " << regions.first << " and " << regions.second;
  }
}

// Layers are a part of their region, on either side of interfaces, and change no wall.
void expectWithLayers(const Soup& soup, const GridSpec& grid, TestOptions options,
  const Expected& expected, double part)
{
  options.grid = grid;
  options.layers.count = 2;
  options.memoryLimit = PlentyOfMemory;
  Execution execution(options.threads);
  const auto assembly = mesh(soup.view(), options, execution);
  const MeshArrays plain = arraysOf(*assembly->mesh, assembly->boxes, execution);
  const MeshArrays layered = withLayers(plain, *assembly->layers);
  constexpr std::size_t FewCells = 100; // all of them may be at edges, where layers end
  EXPECT_TRUE(plain.types.size() < FewCells || layered.types.size() > plain.types.size());
  EXPECT_TRUE(isValid(layered, true));
  expectRegions(layered, expected, part);
}

// By Exact Fit: with cells as they are, then with cells that solvers accept.
void expectExactly(const Soup& soup, const Expected& expected, double contactTolerance = 0)
{
  for (const double cells : { 1.0, 3.7, 8.0, 11.3 })
  {
    for (const int levels : { 0, 1 })
    {
      SCOPED_TRACE(std::to_string(cells) + " cells along the longest dimension, depth " +
        std::to_string(levels));
      const GridSpec grid = cellsAlongLongest(soup, cells);
      TestOptions plain = asTheyAre(0, depth(levels));
      plain.contactTolerance = contactTolerance;
      const Meshed asIs = meshOf(soup, grid, plain);
      EXPECT_TRUE(isValid(asIs.mesh));
      expectRegions(asIs.mesh, expected, 1e-9);
      TestOptions options;
      options.patches = exactFit();
      options.refinement = depth(levels);
      options.contactTolerance = contactTolerance;
      const Meshed shaped = meshOf(soup, grid, options);
      EXPECT_TRUE(isValid(shaped.mesh, true));
      expectRegions(shaped.mesh, expected, 1e-9);
      if (cells == 3.7)
      {
        expectWithLayers(soup, grid, options, expected, 1e-9);
      }
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
      if (cells == 8.0)
      {
        expectWithLayers(soup, cellsAlongLongest(soup, cells), options, expected, slack);
      }
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

// Of height 2 over a regular polygon around the z axis; boundary 0: the side, 1 and 2: the ends.
Soup prism(int corners, double radius, double firstAngle = 0)
{
  Soup soup;
  for (int i = 0; i < corners; ++i)
  {
    const double angle = firstAngle + 2 * Pi * i / corners;
    for (const double z : { 0., 2. })
    {
      soup.points.push_back({ radius * std::cos(angle), radius * std::sin(angle), z });
    }
  }
  const auto low = [&](int i) { return static_cast<std::uint32_t>(2 * (i % corners)); };
  const auto high = [&](int i) { return low(i) + 1; };
  for (int i = 0; i < corners; ++i)
  {
    soup.triangles.push_back({ low(i), low(i + 1), high(i) });
    soup.triangles.push_back({ low(i + 1), high(i + 1), high(i) });
    soup.boundary.insert(soup.boundary.end(), { 0, 0 });
  }
  for (int i = 1; i + 1 < corners; ++i)
  {
    soup.triangles.push_back({ low(0), low(i + 1), low(i) });
    soup.triangles.push_back({ high(0), high(i), high(i + 1) });
    soup.boundary.insert(soup.boundary.end(), { 1, 2 });
  }
  return soup;
}

double areaOf(int corners, double radius)
{
  return corners * radius * radius * std::sin(2 * Pi / corners) / 2;
}

double sideOf(int corners, double radius)
{
  return 2 * 2 * corners * radius * std::sin(Pi / corners);
}

// Around the z axis, with as many corners inside as outside. Boundary 3: the bore.
Soup pipe(int corners, double inner, double outer, double firstAngle)
{
  Soup soup = prism(corners, outer, firstAngle);
  Soup bore = prism(corners, inner, firstAngle).flipped();
  const auto sides = static_cast<std::size_t>(2 * corners);
  const auto next = static_cast<std::uint32_t>(soup.points.size());
  soup.triangles.resize(sides);
  soup.boundary.resize(sides);
  soup.points.insert(soup.points.end(), bore.points.begin(), bore.points.end());
  for (std::size_t t = 0; t < sides; ++t)
  {
    const auto& c = bore.triangles[t];
    soup.triangles.push_back({ c[0] + next, c[1] + next, c[2] + next });
    soup.boundary.push_back(3);
  }
  const auto at = [&](
                    int i, int end) { return static_cast<std::uint32_t>(2 * (i % corners) + end); };
  for (int i = 0; i < corners; ++i)
  {
    soup.triangles.push_back({ at(i, 0), at(i, 0) + next, at(i + 1, 0) });
    soup.triangles.push_back({ at(i, 0) + next, at(i + 1, 0) + next, at(i + 1, 0) });
    soup.triangles.push_back({ at(i, 1), at(i + 1, 1), at(i, 1) + next });
    soup.triangles.push_back({ at(i + 1, 1), at(i + 1, 1) + next, at(i, 1) + next });
    soup.boundary.insert(soup.boundary.end(), { 1, 1, 2, 2 });
  }
  return soup;
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

// Three, with walls of these widths.
Soup nestedBoxes(double inner, double outer)
{
  Soup soup;
  for (const double wall : { 0.0, inner, inner + outer })
  {
    soup.addRegion(
      box({ -0.4 - wall, -0.3 - wall, -0.2 - wall }, { 0.4 + wall, 0.3 + wall, 0.2 + wall }));
  }
  return soup;
}

// What checkMesh refuses of a region by itself.
std::string invalidIn(const MeshArrays& mesh, int region)
{
  const Quality quality = qualityOf(mesh, region);
  const auto most = [&](Measure measure) {
    return *std::max_element(quality.cells[measure].begin(), quality.cells[measure].end());
  };
  std::string found;
  for (const auto& [measure, limit] : { std::pair{ BoundaryAngle, 90.0 }, { InnerAngle, 90.0 },
         { Skewness, 4.0 }, { AspectRatio, 1000.0 } })
  {
    if (!(most(measure) < limit))
    {
      found += std::string(MeasureSpecs[measure].name) + " " + std::to_string(most(measure)) + " ";
    }
  }
  return found;
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

// A ball on a table, which it touches at its lowest point, or where it is flattened by so much.
TEST(Regions, MayTouchAPlaneWithASphere)
{
  for (const double flattened : { 0.0, 0.1 })
  {
    SCOPED_TRACE(flattened);
    const Soup ball = sphere(6, 1).each([&](const Vector& p) {
      return Vector{ p[0], p[1], std::max(p[2] + 1 - flattened, 0.) };
    });
    double flat = 0;
    for (std::size_t t = 0; t < ball.triangles.size(); ++t)
    {
      const auto& c = ball.triangles[t];
      const bool isFlat = ball.points[c[0]][2] + ball.points[c[1]][2] + ball.points[c[2]][2] == 0;
      flat += isFlat ? ball.area(t) : 0;
    }
    EXPECT_EQ(flat > 0, flattened > 0);
    Soup soup;
    soup.addRegion(ball);
    soup.addRegion(box({ -1.5, -1.5, -1 }, { 1.5, 1.5, 0 }));
    Expected expected{ { { 1, ball.volume() }, { 2, 9 } },
      { { { 0, 1 }, ball.area() - flat }, { { 0, 2 }, 30 - flat } } };
    if (flat > 0)
    {
      expected.areas[{ 1, 2 }] = flat;
    }
    expectExactly(soup, expected);
  }
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
  expectNearly(soup, expected, 0.3); // at 3.7 boxes, the ball has a diameter of 1.4
}

// Concave corners, and walls thinner than a box, where no cell can be removed.
TEST(Regions, AreValidEachByItself)
{
  for (const auto& [inner, outer] :
    { std::pair{ 0.0731, 0.0512 }, { 0.1637, 0.0405 }, { 0.0487, 0.1123 } })
  {
    Soup soup = nestedBoxes(inner, outer);
    const std::vector<std::int32_t> regions = soup.region;
    soup = soup.turned();
    soup.region = regions;
    const MeshArrays mesh = meshOf(soup, cellsAlongLongest(soup, 19), TestOptions{}).mesh;
    EXPECT_TRUE(isValid(mesh, true));
    for (const int region : { 1, 2, 3 })
    {
      EXPECT_EQ(invalidIn(mesh, region), "")
        << "region " << region << ", walls " << inner << " and " << outer;
    }
  }
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

TEST(Regions, ThatPassThroughEachOtherGiveWayToTheFirst)
{
  Soup soup;
  soup.addRegion(cube());
  soup.addRegion(box({ 0.5, 0.25, 0.25 }, { 2, 0.75, 0.75 }));
  expectExactly(soup,
    { { { 1, 1 }, { 2, 0.25 } },
      { { { 0, 1 }, 6 - 0.25 }, { { 0, 2 }, 0.25 + 4 * 0.5 }, { { 1, 2 }, 0.25 } } });
}

// Turned, so that no walls lie in planes of the grid: a plate, a block in a corner of it, and a bar through both.
TEST(Regions, ThreeThatCross)
{
  Soup soup;
  soup.addRegion(box({ 0, 0, 0 }, { 2, 2, 0.5 }));
  soup.addRegion(box({ 1, 1, -0.5 }, { 2.5, 2.5, 1 }));
  soup.addRegion(box({ 1.5, 1.5, -1 }, { 1.75, 1.75, 2 }));
  expectExactly(soup.turned(),
    { { { 1, 2 }, { 2, 3.375 - 0.5 }, { 3, 0.0625 * 1.5 } },
      { { { 0, 1 }, 9 }, { { 0, 2 }, 12.375 }, { { 0, 3 }, 1.625 }, { { 1, 2 }, 3 },
        { { 2, 3 }, 0.125 } } });
}

TEST(Regions, TheFirstKeepsTheVolume)
{
  Soup soup;
  soup.addRegion(cube());
  soup.addRegion(box({ 0.3, 0.2, 0.4 }, { 0.7, 0.8, 0.6 }));
  expectRefusal(soup, "Nothing is left of region 2");
}

// Facets of 24 and of 17 cross each other; the rod, the first, keeps its wall, which the pipe gets too.
TEST(Regions, CurvedWallsOfOtherTrianglesBecomeOneWithinTheTolerance)
{
  const double rod = areaOf(24, 0.5);
  const double whole = areaOf(17, 0.8);
  const Expected expected{ { { 1, 2 * rod }, { 2, 2 * (whole - rod) } },
    { { { 0, 1 }, 2 * rod }, { { 0, 2 }, 2 * (whole - rod) + sideOf(17, 0.8) },
      { { 1, 2 }, sideOf(24, 0.5) } } };
  for (const double inner : { 0.48, 0.5, 0.53 })
  {
    SCOPED_TRACE(inner);
    Soup soup;
    soup.addRegion(prism(24, 0.5));
    soup.addRegion(pipe(17, inner, 0.8, 0.1));
    expectExactly(inner == 0.5 ? soup.turned() : soup, expected, 0.05);
  }
}

TEST(Regions, TheFirstWallStaysWhicheverItIs)
{
  const double bore = areaOf(17, 0.5);
  const double whole = areaOf(17, 0.8);
  Soup soup;
  soup.addRegion(pipe(17, 0.5, 0.8, 0.1));
  soup.addRegion(prism(24, 0.49));
  expectExactly(soup,
    { { { 1, 2 * (whole - bore) }, { 2, 2 * bore } },
      { { { 0, 1 }, 2 * (whole - bore) + sideOf(17, 0.8) }, { { 0, 2 }, 2 * bore },
        { { 1, 2 }, sideOf(17, 0.5) } } },
    0.05);
}

TEST(Regions, AClosedWallInsideBecomesOneWithinTheTolerance)
{
  Soup soup;
  soup.addRegion(sphere(3, 0.5));
  Soup shell = box({ -1, -1, -1 }, { 1, 1, 1 });
  shell.add(sphere(4, 0.505).flipped());
  soup.addRegion(shell);
  const double ball = sphere(3, 0.5).volume();
  expectExactly(soup,
    { { { 1, ball }, { 2, 8 - ball } }, { { { 0, 2 }, 24 }, { { 1, 2 }, sphere(3, 0.5).area() } } },
    0.08);
}

TEST(Regions, WallsBeyondTheToleranceStay)
{
  Soup soup;
  soup.addRegion(prism(24, 0.4));
  soup.addRegion(pipe(17, 0.5, 0.8, 0.1));
  const double rod = areaOf(24, 0.4);
  const double ring = areaOf(17, 0.8) - areaOf(17, 0.5);
  expectExactly(soup,
    { { { 1, 2 * rod }, { 2, 2 * ring } },
      { { { 0, 1 }, 2 * rod + sideOf(24, 0.4) },
        { { 0, 2 }, 2 * ring + sideOf(17, 0.8) + sideOf(17, 0.5) } } },
    0.05);
}

// 100 bricks, each with diagonals of its own.
TEST(Regions, LieFaceToFace)
{
  Soup soup;
  Expected expected;
  const std::array<int, 3> counts{ 5, 5, 4 };
  const auto number = [&](int i, int j, int k) {
    return i < 0 || j < 0 || k < 0 || i >= counts[0] || j >= counts[1] || k >= counts[2]
      ? 0
      : 1 + i + counts[0] * (j + counts[1] * k);
  };
  for (int k = 0; k < counts[2]; ++k)
  {
    for (int j = 0; j < counts[1]; ++j)
    {
      for (int i = 0; i < counts[0]; ++i)
      {
        const Vector low{ 0.25 * i, 0.25 * j, 0.25 * k };
        const bool other = (i + j + k) % 2 != 0;
        const Soup brick = box({ 0, 0, 0 }, { 0.25, 0.25, 0.25 });
        const auto mirrored = [](const Vector& p) { return Vector{ 0.25 - p[0], p[1], p[2] }; };
        soup.addRegion((other ? brick.each(mirrored).flipped() : brick).moved(low));
        const int own = number(i, j, k);
        expected.volumes[own] = 1. / 64;
        for (const int beside : { number(i - 1, j, k), number(i + 1, j, k), number(i, j - 1, k),
               number(i, j + 1, k), number(i, j, k - 1), number(i, j, k + 1) })
        {
          if (beside < own)
          {
            expected.areas[{ beside, own }] += 1. / 16;
          }
        }
      }
    }
  }
  TestOptions options;
  options.patches = exactFit();
  for (const double cells : { 5.0, 7.3 })
  {
    const Meshed meshed = meshOf(soup, cellsAlongLongest(soup, cells), options);
    EXPECT_TRUE(isValid(meshed.mesh, true));
    expectRegions(meshed.mesh, expected, 1e-9);
  }
}

// A shaft in a bush, from almost no gap or overlap up to half a box: where it is closed, the shaft
// keeps its volume, and nothing is between them.
TEST(Regions, CloseAnyGapWithinTheTolerance)
{
  const double shaft = areaOf(24, 0.5);
  const double whole = areaOf(17, 0.9);
  TestOptions options;
  options.patches = exactFit();
  for (const double gap : { -0.1, -1e-3, -1e-6, 1e-6, 1e-4, 1e-2, 0.1 })
  {
    SCOPED_TRACE(gap);
    Soup soup;
    soup.addRegion(prism(24, 0.5));
    soup.addRegion(pipe(17, 0.5 + gap, 0.9, 0.1));
    options.contactTolerance = std::abs(gap) + 0.02;
    const Meshed meshed = meshOf(soup, cellsAlongLongest(soup, 9.3), options);
    EXPECT_TRUE(isValid(meshed.mesh, true));
    expectRegions(meshed.mesh,
      { { { 1, 2 * shaft }, { 2, 2 * (whole - shaft) } },
        { { { 0, 1 }, 2 * shaft }, { { 0, 2 }, 2 * (whole - shaft) + sideOf(17, 0.9) },
          { { 1, 2 }, sideOf(24, 0.5) } } },
      1e-9);
  }
}
