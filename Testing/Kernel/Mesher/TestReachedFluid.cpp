// What Keep Points reach among open surfaces, and the air above terrain: volumes and areas are known by construction.
#include "Mesher/ReachedFluid.h"

#include "Support/Effort.h"
#include "Support/MeshChecker.h"
#include "Surface/SurfaceEdges.h"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

using namespace cartesian;

namespace
{

constexpr std::int32_t FirstPlate = 0; // the six around the fluid
constexpr std::int32_t Body = 6;
constexpr std::int32_t Pocket = 7;
constexpr std::int32_t Blade = 8;

using Random = std::mt19937;

double between(Random& random, double low, double high)
{
  return std::uniform_real_distribution<double>(low, high)(random);
}

// With triangles that face either way.
void addRectangle(
  const std::array<Vector, 4>& corners, std::int32_t boundary, Random& random, Soup& soup)
{
  const auto first = static_cast<std::uint32_t>(soup.points.size());
  soup.points.insert(soup.points.end(), corners.begin(), corners.end());
  for (const std::uint32_t second : { 1U, 2U })
  {
    const bool isTurned = random() % 2 == 0;
    soup.triangles.push_back(
      { first, first + second + (isTurned ? 1 : 0), first + second + (isTurned ? 0 : 1) });
    soup.boundary.push_back(boundary);
  }
}

// Across an axis, at a level of it, from low to high of the other two.
void addPlate(std::size_t axis, double at, const std::array<double, 4>& extent,
  std::int32_t boundary, Random& random, Soup& soup)
{
  const auto corner = [&](std::size_t u, std::size_t v) {
    Vector p{};
    p[axis] = at;
    p[(axis + 1) % 3] = extent[u];
    p[(axis + 2) % 3] = extent[2 + v];
    return p;
  };
  addRectangle({ corner(0, 0), corner(1, 0), corner(1, 1), corner(0, 1) }, boundary, random, soup);
}

// The sides of a box; without the upper one along z, if it is open.
void addBox(const Vector& low, const Vector& high, bool isOpen, std::int32_t boundary,
  Random& random, Soup& soup)
{
  for (std::size_t axis = 0; axis < 3; ++axis)
  {
    const std::size_t u = (axis + 1) % 3;
    const std::size_t v = (axis + 2) % 3;
    for (const double at : { low[axis], high[axis] })
    {
      if (!isOpen || axis != 2 || at != high[axis])
      {
        addPlate(axis, at, { low[u], high[u], low[v], high[v] }, boundary, random, soup);
      }
    }
  }
}

struct Scene
{
  Soup soup;
  Vector point{};
  double volume = 0;
  std::array<double, 9> area{}; // of boundaries
};

// Six plates that reach beyond each other; in the space between them a box, a pocket that is open outside, and a blade that
// comes in through a wall.
Scene enclosed(unsigned seed)
{
  Random random(seed);
  Scene scene;
  const Vector size{ between(random, 0.8, 1.2), between(random, 0.8, 1.2),
    between(random, 0.8, 1.2) };
  scene.volume = size[0] * size[1] * size[2];
  for (std::size_t axis = 0; axis < 3; ++axis)
  {
    const std::size_t u = (axis + 1) % 3;
    const std::size_t v = (axis + 2) % 3;
    for (const double at : { 0., size[axis] })
    {
      const auto beyond = [&] { return between(random, 0.1, 0.5); };
      const std::array<double, 4> extent{ -beyond(), size[u] + beyond(), -beyond(),
        size[v] + beyond() };
      const auto plate = static_cast<std::int32_t>(2 * axis + (at > 0 ? 1 : 0));
      addPlate(axis, at, extent, FirstPlate + plate, random, scene.soup);
      scene.area[static_cast<std::size_t>(plate)] = size[u] * size[v];
    }
  }
  const Vector low{ between(random, 0.1, 0.15), between(random, 0.1, 0.15),
    between(random, 0.1, 0.3) };
  const Vector high{ low[0] + 0.2, low[1] + 0.25, low[2] + 0.3 };
  addBox(low, high, false, Body, random, scene.soup);
  scene.volume -= 0.2 * 0.25 * 0.3;
  scene.area[Body] = 2 * (0.2 * 0.25 + 0.25 * 0.3 + 0.2 * 0.3);
  const double depth = between(random, 0.1, 0.3);
  addBox(
    { 0.45, 0.45, size[2] - depth }, { 0.7, 0.7, size[2] + 0.2 }, true, Pocket, random, scene.soup);
  scene.volume -= 0.25 * 0.25 * depth;
  scene.area[Pocket] = 0.25 * 0.25 + 4 * 0.25 * depth;
  scene.area[5] -= 0.25 * 0.25;
  const double reach = between(random, 0.1, 0.25);
  addPlate(1, 0.3, { size[2] - 0.4, size[2] - 0.1, size[0] - reach, size[0] + 0.3 }, Blade, random,
    scene.soup);
  scene.area[Blade] = 2 * 0.3 * reach;
  scene.point = { 0.05, 0.6, 0.05 };
  return scene;
}

Options optionsFor(const Vector& point, double cellSize)
{
  Options options;
  options.grid = cellsOf(cellSize);
  options.domain.domain = Domain::AroundPoints;
  options.domain.keepPoints = { point };
  return options;
}

std::size_t unbalancedEdges(const Surface& surface)
{
  Execution execution;
  std::size_t unbalanced = 0;
  SurfaceEdges(surface, execution)
    .forEach([&](std::uint32_t, const EdgeUse* begin, const EdgeUse* end) {
      const auto down = std::count_if(begin, end, [](const EdgeUse& use) { return use.down(); });
      unbalanced += 2 * down != end - begin ? 1 : 0;
    });
  return unbalanced;
}

std::map<std::int32_t, double> areasOf(const Surface& surface)
{
  std::map<std::int32_t, double> areas;
  const double step = surface.lattice.step();
  for (std::size_t t = 0; t < surface.triangles.size(); ++t)
  {
    const Corners c = surface.corners(t);
    areas[surface.boundary[t]] +=
      norm(cross(minus(c[1], c[0]), minus(c[2], c[0]))) / 2 * step * step;
  }
  return areas;
}

// As turned() turns one of the soups, whose last point is the Keep Point.
Scene turned(Scene scene, unsigned way)
{
  scene.soup.points.push_back(scene.point);
  scene.soup = way == 0 ? scene.soup
                        : (way == 1 ? scene.soup.turned(2, 45)
                                    : (way == 2 ? scene.soup.turned(0, 30) : scene.soup.turned()));
  scene.point = scene.soup.points.back();
  scene.soup.points.pop_back();
  return scene;
}

// Sheets get a thickness of a few levels, which their areas and the volume feel.
constexpr double Thickness = 1e-6;

void expectReached(const Scene& scene, const PreparedSurface& prepared)
{
  ASSERT_TRUE(prepared.fluid.has_value());
  EXPECT_EQ(unbalancedEdges(prepared.surface), 0U);
  EXPECT_NEAR(volumeOf(prepared.surface), scene.volume, Thickness);
  const std::map<std::int32_t, double> areas = areasOf(prepared.surface);
  for (const auto& [boundary, area] : areas)
  {
    EXPECT_NEAR(area, scene.area[static_cast<std::size_t>(boundary)], Thickness) << boundary;
  }
  EXPECT_EQ(areas.size(), scene.area.size());
}

}

TEST(ReachedFluid, PlatesThatEncloseItTogether)
{
  constexpr std::array<double, 3> sizes{ 0.31, 0.17, 0.09 };
  Execution execution;
  for (unsigned seed = 0; seed < repeats(60); ++seed)
  {
    SCOPED_TRACE(seed);
    const Scene scene = turned(enclosed(seed), seed % 4);
    const PreparedSurface prepared =
      prepareSurface(scene.soup.view(), optionsFor(scene.point, sizes[seed % 3]), execution);
    expectReached(scene, prepared);
  }
}

TEST(ReachedFluid, DoesNotDependOnBoxesOrThreads)
{
  const Scene scene = turned(enclosed(5), 3);
  Execution one;
  Execution several(4);
  const PreparedSurface coarse =
    prepareSurface(scene.soup.view(), optionsFor(scene.point, 0.31), one);
  const PreparedSurface fine =
    prepareSurface(scene.soup.view(), optionsFor(scene.point, 0.05), one);
  const PreparedSurface threaded =
    prepareSurface(scene.soup.view(), optionsFor(scene.point, 0.31), several);
  EXPECT_NEAR(volumeOf(coarse.surface), volumeOf(fine.surface), 1e-12);
  EXPECT_EQ(coarse.surface.vertices, threaded.surface.vertices);
  EXPECT_EQ(coarse.surface.triangles, threaded.surface.triangles);
  EXPECT_EQ(coarse.surface.boundary, threaded.surface.boundary);
}

TEST(ReachedFluid, TheMeshFillsIt)
{
  for (const unsigned way : cases({ 0U, 1U, 2U, 3U }))
  {
    SCOPED_TRACE(way);
    const Scene scene = turned(enclosed(7), way);
    TestOptions options = asTheyAre();
    options.domain = optionsFor(scene.point, 0.11).domain;
    const MeshArrays mesh = meshOf(scene.soup, cellsOf(0.11), options).mesh;
    EXPECT_TRUE(isValid(mesh));
    EXPECT_NEAR(volumesByRegion(mesh).begin()->second, scene.volume, 2 * Thickness);
  }
}

TEST(ReachedFluid, ALeakIsNone)
{
  Scene scene = enclosed(1);
  Soup open = scene.soup;
  open.triangles.erase(open.triangles.begin(), open.triangles.begin() + 2);
  open.boundary.erase(open.boundary.begin(), open.boundary.begin() + 2);
  Execution execution;
  EXPECT_FALSE(
    prepareSurface(open.view(), optionsFor(scene.point, 0.17), execution).fluid.has_value());
}

TEST(ReachedFluid, RimsThatEndAHairBeforeWalls)
{
  for (const double gap : { 0., 1e-6, 1e-4 })
  {
    Random random(3);
    Scene scene;
    addBox({ 0, 0, 0 }, { 1, 1, 1 }, false, Body, random, scene.soup);
    addPlate(1, 0.4, { gap, 1 - gap, gap, 1 - gap }, Blade, random, scene.soup);
    scene.point = { 0.5, 0.2, 0.5 };
    scene = turned(scene, 3);
    Execution execution;
    const PreparedSurface prepared =
      prepareSurface(scene.soup.view(), optionsFor(scene.point, 0.17), execution);
    ASSERT_TRUE(prepared.fluid.has_value());
    EXPECT_NEAR(volumeOf(prepared.surface), 0.4, 2 * gap + 1e-8);
  }
}

TEST(ReachedFluid, ABaffleWithOneSideHasNoBack)
{
  Random random(3);
  Scene scene;
  addBox({ 0, 0, 0 }, { 1, 1, 1 }, false, Body, random, scene.soup);
  addPlate(1, 0.4, { -0.1, 1.1, -0.1, 1.1 }, Blade, random, scene.soup);
  Options options = optionsFor({ 0.5, 0.2, 0.5 }, 0.17);
  constexpr std::int32_t Back = 9;
  options.baffles = { { Blade, Back } };
  Execution execution;
  const PreparedSurface prepared = prepareSurface(scene.soup.view(), options, execution);
  const std::map<std::int32_t, double> areas = areasOf(prepared.surface);
  EXPECT_EQ(areas.count(Back), 0U);
  EXPECT_NEAR(areas.at(Blade), 1, 1e-8);
}

namespace
{

// Heights over a grid of lines, piecewise linear; its first and last lines are these.
struct Land
{
  std::array<std::vector<double>, 2> lines;
  std::vector<double> heights;
  Soup soup;

  double heightAt(std::size_t i, std::size_t j) const { return heights[j * lines[0].size() + i]; }
};

constexpr int Lines = 9;

// `beyond`: where the outermost lines are from the sides of the square from 0 to 1.
Land landOf(unsigned seed, double beyond)
{
  Random random(seed);
  Land land;
  for (std::vector<double>& along : land.lines)
  {
    for (int i = 0; i <= Lines; ++i)
    {
      along.push_back(double(i) / Lines);
    }
    if (beyond > 0)
    {
      along.insert(along.begin(), -beyond);
      along.push_back(1 + beyond);
    }
    else
    {
      along.front() -= beyond;
      along.back() += beyond;
    }
  }
  const bool isTurned = random() % 2 == 0; // as a whole
  for (const double y : land.lines[1])
  {
    for (const double x : land.lines[0])
    {
      land.heights.push_back(between(random, 0.1, 0.3));
      land.soup.points.push_back({ x, y, land.heights.back() });
    }
  }
  const auto across = static_cast<std::uint32_t>(land.lines[0].size());
  for (std::uint32_t j = 0; j + 1 < land.lines[1].size(); ++j)
  {
    for (std::uint32_t i = 0; i + 1 < across; ++i)
    {
      const std::uint32_t a = j * across + i;
      std::array<std::array<std::uint32_t, 3>, 2> two{ { { a, a + 1, a + across + 1 },
        { a, a + across + 1, a + across } } };
      for (std::array<std::uint32_t, 3>& t : two)
      {
        if (isTurned)
        {
          std::swap(t[1], t[2]);
        }
        land.soup.triangles.push_back(t);
        land.soup.boundary.push_back(0);
      }
    }
  }
  return land;
}

// Of what is below it in the square from 0 to 1, as far as its lines reach; outermost lines are continued level.
double volumeBelow(const Land& land)
{
  double volume = 0;
  const auto& [xs, ys] = land.lines;
  for (std::size_t j = 0; j + 1 < ys.size(); ++j)
  {
    for (std::size_t i = 0; i + 1 < xs.size(); ++i)
    {
      const double a = land.heightAt(i, j);
      const double b = land.heightAt(i + 1, j);
      const double c = land.heightAt(i + 1, j + 1);
      const double d = land.heightAt(i, j + 1);
      const bool isWithin = xs[i] >= 0 && xs[i + 1] <= 1 && ys[j] >= 0 && ys[j + 1] <= 1;
      volume +=
        isWithin ? (xs[i + 1] - xs[i]) * (ys[j + 1] - ys[j]) / 6 * ((a + b + c) + (a + c + d)) : 0;
    }
  }
  return volume;
}

TestOptions optionsForLand(bool byPoint)
{
  TestOptions options = asTheyAre();
  options.domain.domain = Domain::Outside;
  options.domain.boxFrom = BoxSource::Bounds;
  options.domain.bounds = { { 0, 0, -0.2 }, { 1, 1, 0.9 } };
  options.domain.ground = DomainSide::NoSide;
  if (byPoint)
  {
    options.domain.keepPoints = { { 0.5, 0.5, 0.8 } };
  }
  return options;
}

double meshedVolume(const Soup& soup, double cellSize, const TestOptions& options)
{
  const MeshArrays mesh = meshOf(soup, cellsOf(cellSize), options).mesh;
  EXPECT_TRUE(isValid(mesh));
  return volumesByRegion(mesh).begin()->second;
}

}

// Rims beyond the sides of the box, and at them; faced either way, where a point tells the side.
TEST(ReachedFluid, AirAboveTerrain)
{
  for (unsigned seed = 0; seed < repeats(24); ++seed)
  {
    SCOPED_TRACE(seed);
    const Land land = landOf(seed, seed % 2 == 0 ? 0.2 : 0);
    const double air = 0.9 - volumeBelow(land);
    const double cellSize = std::array{ 0.23, 0.17, 0.11 }[seed % 3];
    EXPECT_NEAR(meshedVolume(land.soup, cellSize, optionsForLand(true)), air, 1e-8);
  }
}

TEST(ReachedFluid, TerrainWithoutAPoint)
{
  const Land land = landOf(2, 0);
  const Vector& normal = cross(minus(land.soup.points[1], land.soup.points[0]),
    minus(land.soup.points[land.lines[0].size()], land.soup.points[0]));
  ASSERT_GT(normal[2], 0);
  const bool facesUp = land.soup.triangles[0][1] == 1;
  const double below = volumeBelow(land) + 0.2;
  const double air = 0.9 + 0.2 - below;
  TestOptions options = optionsForLand(false);
  EXPECT_NEAR(meshedVolume(land.soup, 0.17, options), facesUp ? air : below, 1e-8);
  EXPECT_NEAR(meshedVolume(land.soup.flipped(), 0.17, options), facesUp ? below : air, 1e-8);
  Execution execution;
  options.grid = cellsOf(0.17);
  for (const auto& [ground, seenFrom] :
    { std::pair(DomainSide::ZMin, DomainSide::ZMax), { DomainSide::ZMax, DomainSide::ZMin } })
  {
    options.domain.ground = ground;
    options.domain.bounds.low[2] = -0.2;
    const std::optional<ReachedFluid> fluid =
      prepareSurface(land.soup.view(), options, execution).fluid;
    ASSERT_TRUE(fluid.has_value());
    EXPECT_EQ(fluid->seenFrom, seenFrom);
  }
}

// Of two files, with 6 and 9 squares along the border that they share: slits that are no cracks stay between these.
TEST(ReachedFluid, TerrainOfTilesThatAreDividedDifferently)
{
  Soup tiles;
  for (const std::uint32_t tile : { 0U, 1U })
  {
    const std::uint32_t rows = tile == 0 ? 6 : 9;
    const auto first = static_cast<std::uint32_t>(tiles.points.size());
    for (std::uint32_t j = 0; j <= rows; ++j)
    {
      for (std::uint32_t i = 0; i < 4; ++i)
      {
        const double y = double(j) / rows;
        const double row = std::floor(y * 6);
        const double part = y * 6 - row;
        tiles.points.push_back({ (tile + i / 3.) / 2, y,
          0.2 + 0.05 * ((1 - part) * std::sin(3 * row) + part * std::sin(3 * (row + 1))) });
      }
    }
    for (std::uint32_t j = 0; j < rows; ++j)
    {
      for (std::uint32_t i = 0; i < 3; ++i)
      {
        const std::uint32_t a = first + 4 * j + i;
        tiles.triangles.push_back({ a, a + 1, a + 5 });
        tiles.triangles.push_back({ a, a + 5, a + 4 });
        tiles.boundary.insert(tiles.boundary.end(), 2, static_cast<std::int32_t>(tile));
      }
    }
  }
  double below = 0;
  for (const auto& t : tiles.triangles)
  {
    const std::array<Vector, 3> c{ tiles.points[t[0]], tiles.points[t[1]], tiles.points[t[2]] };
    below += cross(minus(c[1], c[0]), minus(c[2], c[0]))[2] / 6 * (c[0][2] + c[1][2] + c[2][2]);
  }
  for (const double cellSize : { 0.23, 0.11 })
  {
    EXPECT_NEAR(meshedVolume(tiles, cellSize, optionsForLand(true)), 0.9 - below, 1e-7);
  }
}

// Rims that end before the sides are continued level, if a box is wider than what is missing.
TEST(ReachedFluid, TerrainThatEndsBeforeTheSides)
{
  constexpr double Missing = 0.02;
  const Land land = landOf(4, -Missing);
  const auto& [xs, ys] = land.lines;
  double below = volumeBelow(land);
  for (std::size_t i = 0; i + 1 < xs.size(); ++i)
  {
    const std::size_t last = ys.size() - 1;
    below += Missing / 2 *
      ((xs[i + 1] - xs[i]) *
          (land.heightAt(i, 0) + land.heightAt(i + 1, 0) + land.heightAt(i, last) +
            land.heightAt(i + 1, last)) +
        (ys[i + 1] - ys[i]) *
          (land.heightAt(0, i) + land.heightAt(0, i + 1) + land.heightAt(last, i) +
            land.heightAt(last, i + 1)));
  }
  for (const std::size_t i : { std::size_t(0), xs.size() - 1 })
  {
    for (const std::size_t j : { std::size_t(0), ys.size() - 1 })
    {
      below += Missing * Missing * land.heightAt(i, j);
    }
  }
  EXPECT_NEAR(meshedVolume(land.soup, 0.11, optionsForLand(true)), 0.9 - below, 1e-4);
}

// Houses that stand in it, closed, or open where nobody sees it.
TEST(ReachedFluid, HousesOnTerrain)
{
  for (const bool isOpen : { false, true })
  {
    Random random(8);
    Land land = landOf(9, 0.1);
    std::fill(land.heights.begin(), land.heights.end(), 0.2);
    for (Vector& p : land.soup.points)
    {
      p[2] = 0.2;
    }
    Soup house;
    addBox({ 0.3, 0.35, -0.5 }, { 0.6, 0.55, -0.1 }, isOpen, 1, random, house);
    for (Vector& p : house.points)
    {
      p[2] = -p[2]; // the open side is below
    }
    Soup all = land.soup;
    all.add(house);
    EXPECT_NEAR(meshedVolume(all, 0.11, optionsForLand(true)), 0.7 - 0.3 * 0.2 * 0.3, 1e-8)
      << isOpen;
  }
}
