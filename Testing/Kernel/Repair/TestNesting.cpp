// Things in an enclosure, which touch and cross each other or its walls, are obstacles: however they are turned, and
// whichever way they and the enclosure were given.
#include "Support/ConvexBodies.h"
#include "Support/MeshChecker.h"

#include <gtest/gtest.h>

using namespace cartesian;

namespace
{

const Soup Room = box({ 0, 0, 0 }, { 5, 4, 3 });
constexpr double RoomVolume = 60;
constexpr double Rounding = 1e-6; // of single precision, relative

// What a file in single precision has.
Soup rounded(const Soup& soup)
{
  return soup.each([](const Vector& p) {
    const volatile float q[] = { float(p[0]), float(p[1]), float(p[2]) };
    return Vector{ q[0], q[1], q[2] };
  });
}

std::vector<Soup> turns(const Soup& soup)
{
  return { soup, soup.turned(2, 17), soup.turned(), soup.turned(0, 45).turned(1, 30) };
}

// Turned, in three sizes.
void expectVolume(const Soup& all, double volume)
{
  int turn = 0;
  for (const Soup& turned : turns(all))
  {
    for (const double size : { 0.001, 1., 1000. })
    {
      SCOPED_TRACE("turn " + std::to_string(turn) + ", size " + std::to_string(size));
      const Soup scaled = rounded(turned.scaled(size));
      const PreparedSurface prepared = prepare(scaled, cellsAlongLongest(scaled, 5));
      EXPECT_NEAR(volumeOf(prepared.surface) / (size * size * size), volume, Rounding * RoomVolume);
    }
    ++turn;
  }
}

// Whichever way the things, and all, were given.
void expectVolumeAround(const Soup& things, double volume)
{
  for (const bool areAlike : { false, true })
  {
    SCOPED_TRACE(areAlike ? "given alike" : "given as holes");
    Soup all = Room;
    all.add(areAlike ? things : things.flipped());
    expectVolume(all, volume);
    expectVolume(all.flipped(), volume);
  }
}

}

TEST(Nesting, ObstaclesThatCross)
{
  Soup things = box({ 1, 1, 1 }, { 2.03, 2.03, 2 });
  things.add(box({ 1.51, 1.51, 1.55 }, { 3, 3, 2.5 }));
  things.add(box({ 4, 0.5, 0.5 }, { 4.5, 1, 1 }));
  const double common = 0.52 * 0.52 * 0.45;
  expectVolumeAround(things, RoomVolume - (1.0609 + 1.49 * 1.49 * 0.95 - common) - 0.125);
}

// The legs stand on the floor, or end in it.
TEST(Nesting, FurnitureOnTheFloor)
{
  for (const double foot : { 0., -0.1 })
  {
    SCOPED_TRACE(foot);
    Soup table = box({ 1.2, 1.4, 0.72 }, { 2.8, 2.2, 0.76 });
    table.add(box({ 1.9, 1.7, foot }, { 2.1, 1.9, 0.72 }));
    table.add(box({ 3, 1, foot }, { 3.3, 1.3, 0.9 }));
    table.add(box({ 3.1, 1.1, 0.8 }, { 3.5, 1.7, 1.1 }));
    expectVolumeAround(table,
      RoomVolume - 1.6 * 0.8 * 0.04 - 0.04 * 0.72 - 0.09 * 0.9 - 0.4 * 0.6 * 0.3 + 0.2 * 0.2 * 0.1);
  }
}

TEST(Nesting, ACupboardInACorner)
{
  Soup things = box({ 0, 0, 0 }, { 1, 0.5, 2 });
  things.add(box({ 1, 0, 0 }, { 2, 0.4, 2 }));
  expectVolumeAround(things, RoomVolume - 1 - 0.8);
}

// Each crosses its neighbours; those below stand on the floor.
TEST(Nesting, ABedOfPebbles)
{
  std::vector<Soup> bodies;
  Soup bed;
  for (int i = 0; i < 18; ++i)
  {
    const Vector middle{ 0.9 + i % 3, 0.8 + i / 3 % 3, 0.3 + 0.8 * (i / 9) };
    bodies.push_back(i < 9 ? box({ -0.48, -0.48, -0.3 }, { 0.48, 0.48, 0.3 }).turned(2, 13 * i)
                           : octahedron(0.62).turned(1, 7 * i));
    bodies.back() = bodies.back().moved(middle);
    bed.add(bodies.back());
  }
  expectVolumeAround(bed, RoomVolume - volumeOfUnion(bodies));
}

// A pipe through both walls of a vessel, given as a hole in it.
TEST(Nesting, APipeThroughAVessel)
{
  const Soup pipe = box({ -0.5, 1.5, 1 }, { 5.5, 2, 1.5 });
  expectVolume(Soup(Room).add(pipe.flipped()), RoomVolume - 5 * 0.25);
  expectVolume(Soup(Room).add(pipe), RoomVolume + 0.25);
}

// The mesh, inside and around a point in the room.
TEST(Nesting, MeshesAroundObstacles)
{
  Soup things = box({ 1, 1, 1 }, { 2.03, 2.03, 2 });
  things.add(box({ 1.51, 1.51, 1.55 }, { 3, 3, 2.5 })).add(box({ 1.2, 1.2, 0 }, { 1.5, 1.4, 1 }));
  const double volume = RoomVolume - (1.0609 + 1.49 * 1.49 * 0.95 - 0.52 * 0.52 * 0.45) - 0.3 * 0.2;
  for (const Soup& obstacles : { things, things.flipped() })
  {
    Soup all = Room;
    all.add(obstacles);
    for (const auto domain : { Domain::Inside, Domain::AroundPoints })
    {
      TestOptions options;
      options.patches = exactFit();
      options.domain.domain = domain;
      options.domain.keepPoints = { { 4.4, 3.3, 0.4 } };
      const Meshed meshed = meshOf(all, cellsOf(0.4), options);
      EXPECT_TRUE(isValid(meshed.mesh, true));
      EXPECT_NEAR(volumeOf(meshed.mesh), volume, 1e-6);
    }
  }
}
