// Open surfaces: those that enclose next to nothing are sheets, both sides of which are walls; others are closed.
#include "Support/MeshChecker.h"

#include <gtest/gtest.h>

#include <cmath>
#include <optional>

using namespace cartesian;

namespace
{

constexpr std::int32_t OfSheet = 20; // boundary
const GridSpec Grid = cellsOf(0.4);

// As a part of areas and volumes: a sheet is as thick as 1e-5 of the domain at most, which shows where it is folded.
constexpr double Thin = 1e-4;

using Place = std::function<Vector(double u, double v)>;

// n x n squares, each of two triangles.
Soup patch(int n, const Place& place)
{
  Soup soup;
  const auto row = static_cast<std::uint32_t>(n + 1);
  for (int j = 0; j <= n; ++j)
  {
    for (int i = 0; i <= n; ++i)
    {
      soup.points.push_back(place(double(i) / n, double(j) / n));
    }
  }
  for (std::uint32_t j = 0; j + 1 < row; ++j)
  {
    for (std::uint32_t i = 0; i + 1 < row; ++i)
    {
      const std::uint32_t a = j * row + i;
      soup.triangles.push_back({ a, a + 1, a + row + 1 });
      soup.triangles.push_back({ a, a + row + 1, a + row });
    }
  }
  soup.boundary.assign(soup.triangles.size(), OfSheet);
  return soup;
}

Soup plate()
{
  return patch(4, [](double u, double v) { return Vector{ u - 0.5, 2 * v - 1, 0 }; });
}

// A sixth of a round tube.
Soup vane()
{
  return patch(6, [](double u, double v) {
    return Vector{ std::sin(u - 0.5), 1.5 * v - 0.75, std::cos(u - 0.5) - 1 };
  });
}

Soup fan(int n, const Vector& middle, const std::function<Vector(int)>& rim)
{
  Soup soup;
  soup.points.push_back(middle);
  for (int i = 0; i < n; ++i)
  {
    soup.points.push_back(rim(i));
    soup.triangles.push_back(
      { 0, static_cast<std::uint32_t>(i + 1), static_cast<std::uint32_t>((i + 1) % n + 1) });
  }
  soup.boundary.assign(soup.triangles.size(), OfSheet);
  return soup;
}

Soup disc()
{
  return fan(24, { 0, 0, 0 }, [](int i) {
    const double angle = 3.14159265358979 * i / 12;
    return Vector{ 0.8 * std::cos(angle), 0.8 * std::sin(angle), 0 };
  });
}

// Of a surface, the triangles whose corners all have a z of at most 0.
Soup below(const Soup& soup)
{
  Soup half = soup;
  half.triangles.clear();
  for (const auto& t : soup.triangles)
  {
    if (std::all_of(t.begin(), t.end(), [&](std::uint32_t v) { return soup.points[v][2] < 1e-9; }))
    {
      half.triangles.push_back(t);
    }
  }
  half.boundary.assign(half.triangles.size(), 3);
  return half;
}

Soup bowl()
{
  return below(sphere(6, 0.9));
}

Soup openBox()
{
  Soup soup = box({ -0.5, -0.6, -0.7 }, { 0.5, 0.6, 0 });
  const std::size_t first = soup.triangles.size();
  for (std::size_t t = first; t-- > 0;)
  {
    if (soup.boundaryOf(t) == 5)
    {
      soup.triangles.erase(soup.triangles.begin() + static_cast<std::ptrdiff_t>(t));
      soup.boundary.erase(soup.boundary.begin() + static_cast<std::ptrdiff_t>(t));
    }
  }
  return soup;
}

// As a letter on a wall in z = 0: nothing below, and a lid of 0.79 of its own area.
Soup letter()
{
  Soup soup = box({ -0.5, -0.3, 0 }, { 0.5, 0.3, 0.05 });
  for (std::size_t t = soup.triangles.size(); t-- > 0;)
  {
    if (soup.boundaryOf(t) == 4)
    {
      soup.triangles.erase(soup.triangles.begin() + static_cast<std::ptrdiff_t>(t));
      soup.boundary.erase(soup.boundary.begin() + static_cast<std::ptrdiff_t>(t));
    }
  }
  soup.boundary.assign(soup.triangles.size(), OfSheet);
  return soup;
}

Soup wall()
{
  Soup soup = box({ -1, -1, -1 }, { 1, 1, 0 });
  soup.boundary.assign(soup.triangles.size(), 1);
  return soup;
}

// A wing of a fifth of its chord in thickness, open at its root.
Soup halfWing()
{
  return below(sphere(8, 1)).scaled(Vector{ 0.5, 0.1, 1.2 });
}

TestOptions inAFlow()
{
  TestOptions options = asTheyAre();
  options.domain.domain = Domain::Outside;
  options.domain.boxFrom = BoxSource::Bounds;
  options.domain.bounds = { { -2, -2, -2 }, { 2, 2, 2 } };
  options.domain.sides = { 10, 11, 12, 13, 14, 15 };
  return options;
}

std::vector<Soup> turns(const Soup& soup)
{
  return { soup, soup.turned(1, 30), soup.turned(2, 17).turned(0, 7), soup.turned() };
}

void expectSides(const Soup& soup, double volume, double area, const TestOptions& options)
{
  const Meshed meshed = meshOf(soup, Grid, options);
  EXPECT_TRUE(isValid(meshed.mesh, true));
  EXPECT_NEAR(volumeOf(meshed.mesh), volume, Thin * volume);
  EXPECT_NEAR(areasByBoundary(meshed.mesh)[OfSheet], 2 * area, Thin * area);
}

OpenSheets found(const Soup& soup, TestOptions options)
{
  Execution execution;
  options.grid = Grid;
  options.memoryLimit = PlentyOfMemory;
  return prepareSurface(soup.view(), options, execution).openSheets;
}

std::size_t sheetsIn(const Soup& soup, const TestOptions& options)
{
  return found(soup, options).all.size();
}

Soup duct()
{
  Soup soup = box({ -1, -2, -1 }, { 1, 2, 1 });
  soup.boundary.assign(soup.triangles.size(), 1);
  return soup;
}

}

TEST(OpenSheets, AreWallsOnBothSides)
{
  for (const Soup& shape : { plate(), vane(), disc() })
  {
    for (const Soup& soup : turns(shape))
    {
      expectSides(soup, 64, soup.area(), inAFlow());
      EXPECT_EQ(sheetsIn(soup, inAFlow()), 1U);
    }
  }
}

// Among walls: inside, beside a body, through it.
TEST(OpenSheets, AreAmongOtherBodies)
{
  for (const Soup& turned : turns(plate().scaled(0.7)))
  {
    Soup inside = duct();
    inside.add(turned);
    expectSides(inside, 16, turned.area(), asTheyAre());

    Soup beside = cube().scaled(0.3).moved({ 1, 1, 1 });
    beside.boundary.assign(beside.triangles.size(), 1);
    beside.add(turned);
    expectSides(beside, 64 - 0.027, turned.area(), inAFlow());
  }
  Soup through = box({ -0.2, -0.3, -0.4 }, { 0.2, 0.3, 0.4 });
  through.boundary.assign(through.triangles.size(), 1);
  through.add(plate());
  expectSides(through, 64 - 0.192, 2 - 0.24, inAFlow());
}

TEST(OpenSheets, AreInRegions)
{
  Soup soup;
  soup.addRegion(box({ -1, -2, -1 }, { 1, 2, 1 }));
  soup.addRegion(box({ 1, -2, -1 }, { 3, 2, 1 }));
  soup.boundary.assign(soup.triangles.size(), 1);
  const Soup sheet = vane().scaled(0.7).turned();
  soup.add(sheet);
  soup.region.resize(soup.triangles.size(), FirstRegion);
  expectSides(soup, 32, sheet.area(), asTheyAre());
}

// A baffle beside one divides its region as without.
TEST(OpenSheets, AreBesideBaffles)
{
  constexpr std::int32_t Front = 30;
  constexpr std::int32_t Back = 31;
  Soup soup = duct();
  Soup across = patch(1, [](double u, double v) { return Vector{ 2 * u - 1, 1.3, 2 * v - 1 }; });
  across.boundary.assign(2, Front);
  soup.add(across).add(plate().scaled(0.7).turned());
  TestOptions options = asTheyAre();
  options.baffles = { { Front, Back } };
  const Meshed meshed = meshOf(soup, Grid, options);
  EXPECT_TRUE(isValid(meshed.mesh, true));
  EXPECT_EQ(meshed.prepared.surface.walls.given.size(), 2U);
  EXPECT_NEAR(areasByBoundary(meshed.mesh)[OfSheet], 4 * 0.49, Thin);
}

TEST(OpenSheets, AreNoneIfTheyEncloseSomething)
{
  TestOptions closed = inAFlow();
  closed.sheets = SheetHandling::LeaveOut;
  for (const Soup& shape : { bowl(), openBox(), halfWing() })
  {
    for (const Soup& soup : turns(shape))
    {
      EXPECT_EQ(sheetsIn(soup, inAFlow()), 0U);
      EXPECT_TRUE(meshOf(soup, Grid, inAFlow()).mesh == meshOf(soup, Grid, closed).mesh);
    }
  }
}

// If the user says so, whatever they would enclose.
TEST(OpenSheets, AreAllThatAreOpen)
{
  TestOptions options = inAFlow();
  options.sheets = SheetHandling::Keep;
  Soup soup = openBox().turned();
  soup.boundary.assign(soup.triangles.size(), OfSheet);
  expectSides(soup, 64, soup.area(), options);
}

// A lid that does not quite meet the walls is no sheet, nor is a triangle alone.
TEST(OpenSheets, AreNoneIfTheyArePatchesOfWalls)
{
  Soup lid = patch(3, [](double u, double v) { return Vector{ u - 0.5, 1.2 * v - 0.6, 1e-5 }; });
  EXPECT_EQ(sheetsIn(openBox().add(lid), inAFlow()), 0U);
  EXPECT_EQ(sheetsIn(openBox().add(lid.moved({ 0, 0, 0.3 })), inAFlow()), 1U);
  Soup alone = cube();
  Soup triangle = patch(1, [](double u, double v) { return Vector{ 2, u, v }; });
  triangle.triangles.pop_back();
  triangle.boundary.pop_back();
  alone.add(triangle);
  EXPECT_EQ(sheetsIn(alone, inAFlow()), 0U);
}

// Open only on the side that they lie on, wherever on the wall; not if they hover, or lie on it with a part of their rims.
TEST(OpenSheets, AreNoneIfTheyAreLettersOnAWall)
{
  TestOptions closed = inAFlow();
  closed.sheets = SheetHandling::LeaveOut;
  const auto onWall = [](const Vector& by) { return wall().add(letter().moved(by)); };
  for (const Soup& soup : turns(onWall({ 0.13, 0.17, 0 })))
  {
    EXPECT_EQ(sheetsIn(soup, inAFlow()), 0U);
    const Meshed meshed = meshOf(soup, Grid, inAFlow());
    EXPECT_TRUE(isValid(meshed.mesh, true));
    EXPECT_NEAR(volumeOf(meshed.mesh), 64 - 4 - 0.03, Thin);
    EXPECT_TRUE(meshed.mesh == meshOf(soup, Grid, closed).mesh);
  }
  EXPECT_EQ(sheetsIn(wall().add(letter().turned(0, 180)), inAFlow()), 0U);
  EXPECT_EQ(sheetsIn(onWall({ 0, 0, 0.01 }), inAFlow()), 1U);
  EXPECT_EQ(sheetsIn(onWall({ 0.7, 0, 0 }), inAFlow()), 1U);
  TestOptions tolerant = inAFlow();
  tolerant.contactTolerance = 0.011;
  EXPECT_EQ(sheetsIn(onWall({ 0, 0, 0.01 }), tolerant), 0U);
}

TEST(OpenSheets, AreNoneIfTheyLieOnASideOfTheDomain)
{
  const Soup bump = letter().moved({ 0.1, 0.2, -2 });
  EXPECT_EQ(sheetsIn(bump, inAFlow()), 0U);
  const Meshed meshed = meshOf(bump, Grid, inAFlow());
  EXPECT_TRUE(isValid(meshed.mesh, true));
  EXPECT_NEAR(volumeOf(meshed.mesh), 64 - 0.03, Thin);
}

// With one edge; or with the whole rim, from wall to wall.
// Round numbers: a level beyond a plane there would be a film. Of long triangles, in single precision.
TEST(OpenSheets, MayEndAlongPlanes)
{
  constexpr std::uint32_t Corners = 24;
  Soup tube;
  for (std::uint32_t i = 0; i < Corners; ++i)
  {
    const double angle = 2 * 3.14159265358979 * i / Corners;
    const auto x = double(float(0.2 * std::cos(angle)));
    const auto y = double(float(0.2 * std::sin(angle)));
    tube.points.push_back({ x, y, 0.5 });
    tube.points.push_back({ x, y, double(0.97F) });
    const std::uint32_t next = (i + 1) % Corners;
    tube.triangles.push_back({ 2 * i, 2 * next, 2 * next + 1 });
    tube.triangles.push_back({ 2 * i, 2 * next + 1, 2 * i + 1 });
  }
  tube.boundary.assign(tube.triangles.size(), OfSheet);
  TestOptions options;
  options.sheets = SheetHandling::Keep;
  for (int axis = 0; axis < 3; ++axis)
  {
    Soup both = box({ -0.5, -0.5, 0 }, { 0.5, 0.5, 1 });
    both.add(tube);
    both = axis == 0 ? both : both.permuted({ axis, (axis + 1) % 3, (axis + 2) % 3 });
    const Meshed meshed = meshOf(both, cellsOf(0.1), options);
    EXPECT_TRUE(meshed.flawedBoxes.empty()) << axis;
    EXPECT_EQ(meshed.statistics.at("BoxesRebuilt"), 0) << axis;
  }
}

TEST(OpenSheets, MayStandOnWalls)
{
  const Soup upright = patch(4, [](double u, double v) {
    return Vector{ 0.9 * u - 0.45, 0.1, 0.8 * v };
  });
  for (const Soup& soup : turns(wall().add(upright)))
  {
    expectSides(soup, 64 - 4, upright.area(), inAFlow());
  }
  expectSides(upright.moved({ 0, 0, -2 }), 64, upright.area(), inAFlow());
  const Soup partition = patch(4, [](double u, double v) {
    return Vector{ 2 * u - 1, 4 * v - 2, 0.13 };
  });
  for (const Soup& soup : turns(duct().add(partition)))
  {
    expectSides(soup, 16, partition.area(), asTheyAre());
  }
}

std::optional<Fault> errorOf(const Soup& soup)
{
  try
  {
    meshOf(soup, cellsOf(0.25), {});
  }
  catch (const Error& error)
  {
    return error.fault;
  }
  return std::nullopt;
}

Soup dome(double height)
{
  return patch(8, [=](double u, double v) {
    return Vector{ u, v, height * 16 * u * (1 - u) * v * (1 - v) };
  });
}

TEST(OpenSheets, BoundNothingAlone)
{
  const OpenSheets sheets = found(dome(0.3), {});
  EXPECT_TRUE(sheets.all.empty());
  EXPECT_EQ(sheets.boundNothing, 1U);
}

// Flat or nearly so, there is an error; a dome is closed by a lid.
TEST(OpenSheets, AreNothingToMeshAlone)
{
  for (const double height : { 0.0, 0.001 })
  {
    for (const Soup& soup : turns(dome(height)))
    {
      EXPECT_EQ(errorOf(soup), Fault::FlawedSurface);
    }
  }
  const Meshed meshed = meshOf(dome(0.3), cellsOf(0.25), {});
  EXPECT_TRUE(isValid(meshed.mesh, true));
  EXPECT_GT(volumeOf(meshed.mesh), 0.1);
}

TEST(OpenSheets, DoNotDependOnThreadsOrTheOrderOfTriangles)
{
  Soup soup = duct();
  soup.add(vane().scaled(0.7).turned());
  TestOptions options;
  const Meshed one = meshOf(soup, Grid, options);
  std::reverse(soup.triangles.begin(), soup.triangles.end());
  std::reverse(soup.boundary.begin(), soup.boundary.end());
  options.threads = 3;
  EXPECT_TRUE(meshOf(soup, Grid, options).mesh == one.mesh);
}
