// Bodies that cross, touch and overlap become one, or give way to each other, exactly.
#include "Repair/Arrangement.h"

#include "Base/Error.h"
#include "Repair/SurfaceCheck.h"
#include "Repair/TrianglePairs.h"
#include "Repair/WallsOfBodies.h"
#include "Support/ConvexBodies.h"
#include "Support/MeshChecker.h"
#include "Support/Pipeline.h"

#include <gtest/gtest.h>

#include <cmath>
#include <map>
#include <random>

using namespace cartesian;

namespace
{

constexpr unsigned Scenes = 60;

// Bodies at random.
class Scene
{
public:
  explicit Scene(unsigned seed)
    : random_(seed)
  {
  }

  double between(double low, double high)
  {
    return std::uniform_real_distribution<double>(low, high)(random_);
  }
  int whole(int low, int high) { return std::uniform_int_distribution<int>(low, high)(random_); }

  Soup turned(Soup soup)
  {
    for (int axis = 0; axis < 3; ++axis)
    {
      soup = soup.turned(axis, between(0, 360));
    }
    return soup.moved({ between(-1, 1), between(-1, 1), between(-1, 1) });
  }

  Soup convexBody()
  {
    if (whole(0, 2) == 0)
    {
      return turned(octahedron(1).scaled({ between(0.3, 1), between(0.3, 1), between(0.3, 1) }));
    }
    const Vector half{ between(0.2, 1), between(0.2, 1), between(0.2, 1) };
    return turned(box(scaled(half, -1), half));
  }

  std::vector<Soup> convexBodies(int count)
  {
    std::vector<Soup> bodies;
    for (int i = 0; i < count; ++i)
    {
      bodies.push_back(convexBody());
    }
    return bodies;
  }

private:
  std::mt19937 random_;
};

Soup asRegions(const std::vector<Soup>& bodies)
{
  Soup soup;
  for (const Soup& body : bodies)
  {
    soup.addRegion(body);
  }
  return soup;
}

Surface onLatticeOf(const Soup& soup)
{
  Execution execution;
  Bounds bounds = boundsOf(soup.view());
  return onLattice(soup.view(), Lattice(bounds), execution);
}

std::map<int, double> volumesByRegion(const Surface& walls)
{
  std::map<int, double> volumes;
  for (std::size_t t = 0; t < walls.triangles.size(); ++t)
  {
    const Corners c = walls.corners(t);
    const Point& base = walls.vertices[0];
    const double volume = dot(minus(c[0], base), cross(minus(c[1], base), minus(c[2], base))) / 6;
    volumes[walls.walls.behind(walls.boundary[t])] += volume;
    volumes[walls.walls.front(walls.boundary[t])] -= volume;
  }
  for (auto& [region, volume] : volumes)
  {
    volume *= std::pow(walls.lattice.step(), 3);
  }
  return volumes;
}

TEST(Arrangement, RegionsGiveWayByTheirOrder)
{
  for (unsigned seed = 0; seed < Scenes; ++seed)
  {
    SCOPED_TRACE(seed);
    Scene scene(seed);
    const std::vector<Soup> bodies = scene.convexBodies(scene.whole(2, 6));
    Surface surface = onLatticeOf(asRegions(bodies));
    Execution execution;
    arrange(surface, execution);
    std::vector<std::uint32_t> crossing;
    const Surface walls =
      wallsOf(surface, { static_cast<std::int32_t>(bodies.size()), {} }, crossing, execution);
    EXPECT_TRUE(crossing.empty());
    std::map<int, double> volumes = volumesByRegion(walls);
    for (std::size_t n = 1; n <= bodies.size(); ++n)
    {
      const double left = volumeLeft({ bodies.begin(), bodies.begin() + static_cast<int>(n) });
      EXPECT_NEAR(volumes[static_cast<int>(n)], left, 3e-8) << n;
    }
  }
}

// Boxes with corners at whole numbers: faces in common planes, edges on edges.
void expectBoxes(unsigned seed, bool turned)
{
  SCOPED_TRACE(seed);
  Scene scene(seed);
  constexpr int Wide = 5;
  std::array<int, Wide * Wide * Wide> owner{};
  Soup soup;
  const int boxes = scene.whole(2, 8);
  for (int n = 1; n <= boxes; ++n)
  {
    std::array<int, 3> low;
    std::array<int, 3> high;
    for (std::size_t axis = 0; axis < 3; ++axis)
    {
      low[axis] = scene.whole(0, Wide - 1);
      high[axis] = scene.whole(low[axis] + 1, Wide);
    }
    for (int i = 0; i < Wide * Wide * Wide; ++i)
    {
      const std::array<int, 3> at{ i % Wide, i / Wide % Wide, i / (Wide * Wide) };
      bool in = owner[i] == 0;
      for (std::size_t axis = 0; axis < 3; ++axis)
      {
        in = in && at[axis] >= low[axis] && at[axis] < high[axis];
      }
      owner[i] = in ? n : owner[i];
    }
    soup.addRegion(box({ double(low[0]), double(low[1]), double(low[2]) },
      { double(high[0]), double(high[1]), double(high[2]) }));
  }
  if (turned)
  {
    soup = soup.turned();
  }
  Surface surface = onLatticeOf(soup);
  Execution execution;
  arrange(surface, execution);
  std::vector<std::uint32_t> crossing;
  Surface united = surface;
  std::map<int, double> volumes =
    volumesByRegion(wallsOf(surface, { boxes, {} }, crossing, execution));
  EXPECT_TRUE(crossing.empty());
  for (int n = 1; n <= boxes; ++n)
  {
    EXPECT_NEAR(volumes[n], double(std::count(owner.begin(), owner.end(), n)), 3e-7) << n;
  }
  united.region.assign(united.triangles.size(), FirstRegion);
  EXPECT_TRUE(unite(united, { FirstRegion, {} }, crossing, execution));
  EXPECT_NEAR(volumeOf(united),
    double(owner.end() - owner.begin() - std::count(owner.begin(), owner.end(), 0)), 3e-7);
}

TEST(Arrangement, BoxesInCommonPlanes)
{
  for (unsigned seed = 0; seed < Scenes; ++seed)
  {
    expectBoxes(seed, false);
  }
}

// Turned, their faces are in common planes but for what the lattice rounds.
TEST(Arrangement, TurnedBoxesInCommonPlanes)
{
  for (unsigned seed = 0; seed < Scenes; ++seed)
  {
    expectBoxes(seed, true);
  }
}

// Nothing crosses afterwards, and what is left is closed.
TEST(Arrangement, OfManyBodiesHasNothingThatCrosses)
{
  Scene scene(1);
  Soup soup;
  for (int n = 0; n < 50; ++n)
  {
    soup.add(n % 3 == 0 ? scene.turned(torus(scene.whole(3, 12), scene.between(0.3, 1), 0.15))
                        : scene.convexBody());
  }
  Surface surface = onLatticeOf(soup);
  surface.region.assign(surface.triangles.size(), FirstRegion);
  Execution execution;
  const std::size_t triangles = surface.triangles.size();
  arrange(surface, execution);
  EXPECT_GT(surface.triangles.size(), 10 * triangles);
  std::vector<std::uint32_t> crossing;
  ASSERT_TRUE(unite(surface, { FirstRegion, {} }, crossing, execution));
  EXPECT_TRUE(findPairs(surface, execution).pairs.empty());
  const SurfaceCheck checked = check(SurfaceEdges(surface, execution), execution);
  EXPECT_TRUE(checked.oriented());
  EXPECT_GT(volumeOf(surface), 0);
  EXPECT_LT(volumeOf(surface), soup.volume());
}

// Most of a body lies in another one: it is a body all the same, whichever way both were given.
TEST(Arrangement, ABoltInAPlateIsUnitedWithIt)
{
  for (const bool flipped : { false, true })
  {
    Soup soup = box({ 0, 0, 0 }, { 4, 4, 1 });
    soup.add(box({ 1.1, 1.2, -0.05 }, { 1.9, 1.8, 1.02 }));
    const PreparedSurface prepared =
      prepare((flipped ? soup.flipped() : soup).turned(), cellsAlongLongest(soup, 5));
    EXPECT_NEAR(volumeOf(prepared.surface), 16 + 0.8 * 0.6 * 0.07, 1e-7);
  }
}

// Two fans of a thousand slivers each in one plane: a quarter of a million places where they cross.
TEST(Arrangement, SliversAcrossSliversAreGivenUpBeforeTheyAreCut)
{
  constexpr std::uint32_t count = 1000;
  const auto fanAround = [&](const Vector& centre) {
    Soup fan;
    for (std::uint32_t i = 0; i < count; ++i)
    {
      const double angle = 2 * Pi * i / count;
      fan.points.push_back({ std::cos(angle), std::sin(angle), 0 });
      fan.triangles.push_back({ i, (i + 1) % count, count });
    }
    fan.points.push_back(centre);
    return fan;
  };
  Soup soup = fanAround({ 0, 0, 0 });
  soup.add(fanAround({ 0.4, 0.1, 0 }).scaled(0.9));
  soup.points.push_back({ 0, 0, 1 }); // the lattice is of a space
  Surface surface = onLatticeOf(soup);
  surface.region.assign(surface.triangles.size(), FirstRegion);
  const auto given = surface.triangles;
  Execution execution;
  EXPECT_FALSE(arrange(surface, execution));
  EXPECT_EQ(surface.triangles, given);
}

// By Exact Fit: inside their union, outside of it, and as regions in which the earlier one keeps the volume.
TEST(Arrangement, MeshesOfBodiesThatCrossHaveTheirVolumes)
{
  for (unsigned seed = 0; seed < 8; ++seed)
  {
    SCOPED_TRACE(seed);
    Scene scene(seed);
    const std::vector<Soup> bodies = scene.convexBodies(scene.whole(2, 5));
    const double volume = volumeOfUnion(bodies);
    Soup soup;
    for (const Soup& body : bodies)
    {
      soup.add(body);
    }
    TestOptions options;
    options.patches = exactFit();
    const GridSpec grid = cellsAlongLongest(soup, 10);
    const Meshed inside = meshOf(soup, grid, options);
    EXPECT_TRUE(isValid(inside.mesh, true));
    EXPECT_NEAR(volumeOf(inside.mesh), volume, 3e-8);

    const Meshed regions = meshOf(asRegions(bodies), grid, options);
    EXPECT_TRUE(isValid(regions.mesh, true));
    double sum = 0;
    for (const auto& [region, part] : volumesByRegion(regions.mesh))
    {
      const auto count = static_cast<std::ptrdiff_t>(region);
      EXPECT_NEAR(part, volumeLeft({ bodies.begin(), bodies.begin() + count }), 3e-8) << region;
      sum += part;
    }
    EXPECT_NEAR(sum, volume, 3e-8);

    options.domain.domain = Domain::Outside;
    options.domain.before = options.domain.behind = options.domain.beside = 0.5;
    const Meshed outside = meshOf(soup, grid, options);
    EXPECT_TRUE(isValid(outside.mesh, true));
    const Bounds box = boxAround(options.domain, outside.prepared.bounds);
    double whole = 1;
    for (std::size_t axis = 0; axis < 3; ++axis)
    {
      whole *= box.high[axis] - box.low[axis];
    }
    EXPECT_NEAR(volumeOf(outside.mesh), whole - volume, 5e-9 * whole);
  }
}

}
