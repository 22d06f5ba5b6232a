// Bodies whose coordinates are in single precision, as in STL: however near their faces are to each other, however far
// from the origin, they become one, and where that fails, the others do.
#include "Repair/UnitedBodies.h"

#include "Repair/SurfaceCheck.h"
#include "Support/ConvexBodies.h"
#include "Support/Pipeline.h"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

using namespace cartesian;

namespace
{

Soup inSinglePrecision(const Soup& soup)
{
  return soup.each([](const Vector& p) {
    return Vector{ double(float(p[0])), double(float(p[1])), double(float(p[2])) };
  });
}

Soup turnedIn(const Soup& soup, int way)
{
  return way == 0 ? soup
                  : (way == 1 ? soup.turned(2, 17)
                              : (way == 2 ? soup.turned(0, 30).turned(1, 45) : soup.turned()));
}

// Half a unit in the last place of a soup's largest coordinate.
double roundingOf(const Soup& soup)
{
  double largest = 0;
  for (const Vector& p : soup.points)
  {
    for (const double x : p)
    {
      largest = std::max(largest, std::abs(x));
    }
  }
  return largest * std::pow(2, -24);
}

void expectClosed(const Surface& surface)
{
  Execution execution;
  const SurfaceCheck checked = check(SurfaceEdges(surface, execution), execution);
  EXPECT_TRUE(checked.closed());
  EXPECT_TRUE(checked.oriented());
}

// How far its rounded corners put a body's volume off at most.
double boundOf(const Soup& soup)
{
  return 4 * roundingOf(soup) * soup.area();
}

// One cube is moved against the other by less than the file's precision, or by little more.
TEST(UnitedBodies, CubesNearlyInOnePlace)
{
  for (const double size : { 1.0, 0.01, 300.0 })
  {
    for (const double by : { 1e-7, 3e-7, 1e-6, 3e-6, 1e-5, 1e-4 })
    {
      for (const Vector& along : { Vector{ 1, 0, 0 }, Vector{ 1, 1, 0 }, Vector{ 1, 1, 1 } })
      {
        for (int way = 0; way < 4; ++way)
        {
          SCOPED_TRACE(testing::Message() << size << " by " << by << " way " << way);
          Soup soup = cube();
          soup.add(cube().moved(scaled(along, by)));
          soup = inSinglePrecision(turnedIn(soup.scaled(size), way));
          const PreparedSurface prepared = prepare(soup, cellsAlongLongest(soup, 5));
          EXPECT_TRUE(prepared.repair.refused.empty());
          double common = 1;
          for (const double x : along)
          {
            common *= 1 - by * x;
          }
          const double volume = std::pow(size, 3);
          EXPECT_NEAR(volumeOf(prepared.surface), (2 - common) * volume, 1e-6 * volume);
          if (by > 5e-7) // else faces lie in each other, and which are left is by chance
          {
            const double steps = along[0] + along[1] + along[2];
            EXPECT_NEAR(
              areaOf(prepared.surface), (6 + 4 * by * steps) * size * size, 1e-5 * size * size);
          }
          expectClosed(prepared.surface);
        }
      }
    }
  }
}

// A hill, and houses that sink into it, each in a field of its own.
struct Village
{
  Soup hill;
  std::vector<Soup> houses;

  Soup all() const
  {
    Soup soup = hill;
    for (const Soup& house : houses)
    {
      soup.add(house);
    }
    return soup;
  }
};

Village village(unsigned seed, const Vector& place, double size)
{
  std::mt19937 random(seed);
  const auto between = [&](double low, double high) {
    return std::uniform_real_distribution<double>(low, high)(random);
  };
  const auto put = [&](const Soup& soup) { return inSinglePrecision(soup.moved(place)); };
  Village result;
  result.hill = put(octahedron(1).scaled({ size / 2, size / 2, size / 12 }));
  constexpr int Fields = 4;
  for (int n = 0; n < Fields * Fields; ++n)
  {
    const double field = 0.6 * size / Fields;
    const Vector at{ (n % Fields + 0.5) * field - 0.3 * size,
      (n / Fields + 0.5) * field - 0.3 * size, size / 50 };
    const Vector half{ field * between(0.05, 0.3), field * between(0.05, 0.3), size / 20 };
    Soup house = box(scaled(half, -1), half).turned(2, between(0, 90));
    house.boundary.clear();
    result.houses.push_back(put(house.moved(at)));
  }
  return result;
}

// National coordinates: points a few roundings apart lie on edges, or nearly.
TEST(UnitedBodies, HousesOnAHillFarFromTheOrigin)
{
  unsigned seed = 0;
  for (const double far : { 1e5, 7e5, 1e7 })
  {
    // As long as the arrangement needs, and longer.
    for (const double size : { 0.002 * far, 0.01 * far, 0.1 * far })
    {
      for (int i = 0; i < 4; ++i, ++seed)
      {
        SCOPED_TRACE(testing::Message() << far << ", " << size << ", " << seed);
        const Village scene = village(seed, { 0.3 * far, far, 0 }, size);
        const Soup soup = scene.all();
        const PreparedSurface prepared = prepare(soup, cellsAlongLongest(soup, 5));
        EXPECT_TRUE(prepared.repair.refused.empty());
        expectClosed(prepared.surface);
        const auto scaledDown = [&](const Soup& body) {
          return body.moved({ -0.3 * far, -far, 0 }).scaled(1 / size);
        };
        const Soup hill = scaledDown(scene.hill);
        double volume = hill.volume();
        for (const Soup& house : scene.houses)
        {
          volume += volumeOfUnion({ hill, scaledDown(house) }) - hill.volume();
        }
        volume *= std::pow(size, 3);
        EXPECT_NEAR(volumeOf(prepared.surface), volume, boundOf(soup));
      }
    }
  }
}

// Turned boxes far from the origin.
TEST(UnitedBodies, BoxesThatCrossFarFromTheOrigin)
{
  for (unsigned seed = 0; seed < 60; ++seed)
  {
    SCOPED_TRACE(seed);
    std::mt19937 random(seed);
    const auto between = [&](double low, double high) {
      return std::uniform_real_distribution<double>(low, high)(random);
    };
    const double far = std::pow(10, between(1, 3));
    std::vector<Soup> bodies;
    Soup soup;
    for (int n = 0; n < 4; ++n)
    {
      const Vector half{ between(0.2, 1), between(0.2, 1), between(0.2, 1) };
      Soup body = box(scaled(half, -1), half);
      for (int axis = 0; axis < 3; ++axis)
      {
        body = body.turned(axis, between(0, 360));
      }
      body = inSinglePrecision(
        body.moved({ far + between(-1, 1), far + between(-1, 1), far + between(-1, 1) }));
      soup.add(body);
      bodies.push_back(body.moved({ -far, -far, -far }));
    }
    const PreparedSurface prepared = prepare(soup, cellsAlongLongest(soup, 5));
    EXPECT_TRUE(prepared.repair.refused.empty());
    expectClosed(prepared.surface);
    EXPECT_NEAR(volumeOf(prepared.surface), volumeOfUnion(bodies), boundOf(soup));
  }
}

// A flat ornament: its pieces are open, and the lids of their holes lie in the plane of a plate below.
Soup ornament(int rows, int corners)
{
  constexpr double Side = 50;
  Soup soup = box({ 0, 0, 0 }, { Side, Side, 1 });
  soup.boundary.clear();
  for (int n = 0; n < rows * rows; ++n)
  {
    const double radius = 0.4 * Side / rows;
    const Vector at{ Side * (n % rows + 0.5) / rows, Side * (n / rows + 0.5) / rows, 1 };
    Soup piece;
    for (int k = 0; k < corners; ++k)
    {
      const double angle = 2 * M_PI * (k + 0.1 * (n % rows)) / corners;
      for (const double height : { 0.0, 0.5 })
      {
        piece.points.push_back(
          { at[0] + radius * std::cos(angle), at[1] + radius * std::sin(angle), at[2] + height });
      }
    }
    for (int k = 0; k < corners; ++k)
    {
      const auto a = static_cast<std::uint32_t>(2 * k);
      const auto b = static_cast<std::uint32_t>(2 * ((k + 1) % corners));
      piece.triangles.push_back({ a, b, b + 1 });
      piece.triangles.push_back({ a, b + 1, a + 1 });
      if (k > 0 && k + 1 < corners)
      {
        piece.triangles.push_back({ 1, a + 1, b + 1 });
      }
    }
    soup.add(piece);
  }
  return soup;
}

// About in proportion to the triangles, though all pieces lie on one of them.
TEST(UnitedBodies, FlatOrnamentsTakeLittleTime)
{
  const auto volume = [](const Soup& soup) {
    const PreparedSurface prepared = prepare(soup, cellsAlongLongest(soup, 30));
    EXPECT_TRUE(prepared.repair.refused.empty());
    expectClosed(prepared.surface);
    return volumeOf(prepared.surface);
  };
  constexpr int Corners = 16;
  const double area = 0.5 * Corners * std::sin(2 * M_PI / Corners); // of radius 1
  for (int way = 0; way < 4; ++way)
  {
    for (const int rows : { 3, 6, 12 })
    {
      SCOPED_TRACE(testing::Message() << rows << " way " << way);
      const Soup soup =
        inSinglePrecision(turnedIn(ornament(rows, Corners), way).moved({ 100, 100, 150 }));
      EXPECT_NEAR(volume(soup), 2500 * (1 + 0.5 * 0.16 * area), boundOf(soup));
    }
  }
}

// What has no inside stays as it is; others are united all the same, in a room too.
TEST(UnitedBodies, OneGroupDoesNotKeepOthersApart)
{
  for (const double size : { 1.0, 0.01, 300.0 })
  {
    for (int way = 0; way < 4; ++way)
    {
      SCOPED_TRACE(testing::Message() << size << " way " << way);
      Soup soup = kleinBottle(12);
      const std::size_t bottle = soup.triangles.size();
      const double aside = 2 * soup.longest();
      const auto crossing = [&](const Vector& by) {
        Soup boxes = box({ 0, 0, 0 }, { 1, 1, 1 });
        boxes.add(box({ 0.5, 0.25, 0.25 }, { 2, 0.75, 0.75 }));
        return boxes.moved(by);
      };
      soup.add(crossing({ aside, 0, 0 }));
      soup.add(box({ -1, aside, -1 }, { 4, aside + 3, 3 }));
      soup.add(crossing({ 0, aside + 1, 0 }).flipped());
      soup.boundary.clear();
      soup = turnedIn(soup.scaled(size), way);

      Execution execution;
      Bounds bounds = boundsOf(soup.view());
      Surface surface = onLattice(soup.view(), Lattice(bounds), execution);
      surface.byParity.resize(surface.triangles.size());
      for (std::size_t t = 0; t < surface.triangles.size(); ++t)
      {
        surface.byParity[t] = surface.given[t] < bottle ? 1 : 0;
      }
      const double before = volumeOf(surface);
      const UnitedBodies united = uniteBodies(surface, {}, MeshedSide::Inside, execution);
      ASSERT_TRUE(united.before);
      EXPECT_TRUE(united.refused.empty());
      // The part of two boxes that is common counted twice, once out of a body, once into the room.
      EXPECT_NEAR(volumeOf(surface), before, 1e-6 * std::pow(size, 3));
      double area = 0;
      for (std::size_t t = 0; t < surface.triangles.size(); ++t)
      {
        const Corners corners = surface.corners(t);
        area += surface.given[t] < bottle
          ? 0
          : norm(cross(minus(corners[1], corners[0]), minus(corners[2], corners[0]))) / 2;
      }
      const double boxes =
        6 + 4 * 0.5; // four sides of the second, 1 long and 0.5 wide, come to those of the first
      EXPECT_NEAR(area * std::pow(surface.lattice.step(), 2),
        (2 * boxes + 2 * (5 * 3 + 3 * 4 + 4 * 5)) * size * size, 1e-5 * size * size);
    }
  }
}

}
