// Keep Out: whether points are reached, and the way there: gaps have known places and widths.
#include "Mesher/LeakPath.h"
#include "Support/Effort.h"
#include "Support/MeshChecker.h"

#include <gtest/gtest.h>

#include <random>

using namespace cartesian;

namespace
{

// Across an axis, with a square hole.
void addPlateWithHole(std::size_t axis, double at, const std::array<double, 4>& extent,
  const std::array<double, 2>& hole, double width, Soup& soup)
{
  const double half = width / 2;
  const auto add = [&](double lowU, double highU, double lowV, double highV) {
    const auto corner = [&](double u, double v) {
      Vector p{};
      p[axis] = at;
      p[(axis + 1) % 3] = u;
      p[(axis + 2) % 3] = v;
      return p;
    };
    const auto first = static_cast<std::uint32_t>(soup.points.size());
    for (const Vector& p :
      { corner(lowU, lowV), corner(highU, lowV), corner(highU, highV), corner(lowU, highV) })
    {
      soup.points.push_back(p);
    }
    soup.triangles.push_back({ first, first + 1, first + 2 });
    soup.triangles.push_back({ first, first + 2, first + 3 });
    soup.boundary.insert(soup.boundary.end(), 2, static_cast<std::int32_t>(axis));
  };
  const auto [lowU, highU, lowV, highV] = extent;
  add(lowU, highU, lowV, hole[1] - half);
  add(lowU, highU, hole[1] + half, highV);
  add(lowU, hole[0] - half, hole[1] - half, hole[1] + half);
  add(hole[0] + half, highU, hole[1] - half, hole[1] + half);
}

// Two rooms with an opening between them, of which the second is open above.
struct Rooms
{
  double above = 0.2; // widths
  double between = 0.3;
  Vector holeAbove{ 1.4, 0.45, 1 };
  Vector opening{ 1, 0.55, 0.4 };
  Vector inside{ 0.3, 0.2, 0.3 };
  Vector outside{ 1.6, 0.6, 2.1 };
  Soup soup;

  void build()
  {
    const Soup all = box({ 0, 0, 0 }, { 2, 1, 1 });
    for (const auto& triangle : all.triangles)
    {
      const auto isAbove = [&](std::uint32_t v) { return all.points[v][2] == 1; };
      if (!std::all_of(triangle.begin(), triangle.end(), isAbove))
      {
        soup.triangles.push_back(triangle);
        soup.boundary.push_back(3);
      }
    }
    soup.points = all.points;
    addPlateWithHole(2, 1, { 0, 2, 0, 1 }, { holeAbove[0], holeAbove[1] }, above, soup);
    addPlateWithHole(0, 1, { 0, 1, 0, 1 }, { opening[1], opening[2] }, between, soup);
  }

  void turn(unsigned way)
  {
    for (Vector* place : { &holeAbove, &opening, &inside, &outside })
    {
      soup.points.push_back(*place);
    }
    soup = way == 0
      ? soup
      : (way == 1 ? soup.turned(2, 45) : (way == 2 ? soup.turned(0, 30) : soup.turned()));
    for (Vector* place : { &outside, &inside, &opening, &holeAbove })
    {
      *place = soup.points.back();
      soup.points.pop_back();
    }
  }
};

Options optionsFor(const Vector& keep, const Vector& out, double cellSize)
{
  Options options;
  options.grid = cellsOf(cellSize);
  options.domain.domain = Domain::AroundPoints;
  options.domain.keepPoints = { keep };
  options.domain.keepOut = { out };
  return options;
}

std::optional<Leak> leakOf(const Soup& soup, const Options& options)
{
  Execution execution;
  try
  {
    mesh(soup.view(), options, execution);
  }
  catch (const Leak& leak)
  {
    return leak;
  }
  return std::nullopt;
}

void expectGap(const LeakGap& gap, const Vector& middle, double width)
{
  EXPECT_NEAR(gap.width, width, 0.1 * width);
  EXPECT_LT(norm(minus(scaled(plus(gap.across[0], gap.across[1]), 0.5), middle)), 0.25 * width);
}

// Of both gaps, in turn.
void expectWay(const Rooms& rooms, const std::optional<Leak>& leak)
{
  ASSERT_TRUE(leak.has_value());
  ASSERT_EQ(leak->path.gaps.size(), 2U) << leak->what();
  expectGap(leak->path.gaps[0], rooms.opening, rooms.between);
  expectGap(leak->path.gaps[1], rooms.holeAbove, rooms.above);
  EXPECT_LT(norm(minus(leak->path.points.front(), rooms.inside)), 1e-6);
  EXPECT_LT(norm(minus(leak->path.points.back(), rooms.outside)), 1e-6);
}

}

TEST(KeepOut, TheWayPassesTheGapsInTurn)
{
  for (const double size : cases({ 0.07, 0.05, 0.11 }))
  {
    for (unsigned way = 0; way < 4; ++way)
    {
      SCOPED_TRACE(std::to_string(size) + " " + std::to_string(way));
      Rooms rooms;
      rooms.build();
      rooms.turn(way);
      expectWay(rooms, leakOf(rooms.soup, optionsFor(rooms.inside, rooms.outside, size)));
    }
  }
}

TEST(KeepOut, GapsAnywhere)
{
  for (unsigned seed = 0; seed < repeats(8); ++seed)
  {
    SCOPED_TRACE(seed);
    std::mt19937 random(seed);
    const auto between = [&](double low, double high) {
      return std::uniform_real_distribution<double>(low, high)(random);
    };
    Rooms rooms;
    rooms.above = between(0.13, 0.3);
    rooms.between = between(0.13, 0.3);
    rooms.holeAbove = { between(1.3, 1.7), between(0.3, 0.7), 1 };
    rooms.opening = { 1, between(0.3, 0.7), between(0.3, 0.7) };
    rooms.outside = { between(-0.5, 2.5), between(-0.5, 1.5), between(1.4, 2.5) };
    rooms.build();
    rooms.turn(seed % 4);
    expectWay(rooms, leakOf(rooms.soup, optionsFor(rooms.inside, rooms.outside, 0.12)));
  }
}

TEST(KeepOut, WhatIsNotReachedIsNoMatter)
{
  Rooms rooms;
  rooms.build();
  rooms.soup.add(box({ 1.2, 0.2, 0.2 }, { 1.6, 0.6, 0.6 }));
  Options options = optionsFor({ 1.3, 0.3, 0.3 }, rooms.inside, 0.11);
  options.domain.keepOut.push_back({ 7, 7, 7 });
  Execution execution;
  const PreparedSurface prepared = prepareSurface(rooms.soup.view(), options, execution);
  EXPECT_NEAR(volumeOf(prepared.surface), 0.4 * 0.4 * 0.4, 1e-7);
  EXPECT_FALSE(leakOf(rooms.soup, options).has_value());
}

// Six slabs around a room; between two of them is a slot.
TEST(KeepOut, FromTheSidesOfTheDomainBox)
{
  constexpr double Slot = 0.3;
  Soup soup = box({ 0, 0, 0 }, { 3, 3, 0.5 });
  soup.add(box({ 0, 0, 2.5 }, { 3, 3, 3 }));
  soup.add(box({ 0, 0, 0.4 }, { 0.5, 3, 2.6 }));
  soup.add(box({ 2.5, 0, 0.4 }, { 3, 3, 2.6 }));
  soup.add(box({ 0.4, 0, 0.4 }, { 2.6, 0.5, 2.6 }));
  soup.add(box({ 0.4, 2.5, 0.4 }, { 2.6, 3, 2.5 - Slot }));
  Options options;
  options.grid = cellsOf(0.24);
  options.domain.domain = Domain::Outside;
  options.domain.before = options.domain.behind = options.domain.beside = 0.5;
  options.domain.keepOut = { { 1.5, 1.4, 1.5 } };
  const auto leak = leakOf(soup, options);
  ASSERT_TRUE(leak.has_value());
  ASSERT_EQ(leak->path.gaps.size(), 1U) << leak->what();
  EXPECT_NEAR(leak->path.gaps[0].width, Slot, 0.1 * Slot);
  EXPECT_NE(std::string(leak->what()).find("from the sides of the domain box"), std::string::npos);
  options.domain.keepOut = { { 0.2, 0.2, 0.2 } }; // in a slab
  EXPECT_FALSE(leakOf(soup, options).has_value());
}

TEST(KeepOut, InsideOfAClosedBody)
{
  Options options;
  options.grid = cellsOf(0.24);
  options.domain.keepOut = { { 0.5, 0.5, 0.5 } };
  const auto leak = leakOf(cube(), options);
  ASSERT_TRUE(leak.has_value());
  EXPECT_NE(std::string(leak->what()).find("lies in a space that is meshed"), std::string::npos);
  options.domain.keepPoints = { { 0.2, 0.2, 0.2 } };
  const auto beside = leakOf(cube(), options);
  ASSERT_TRUE(beside.has_value());
  EXPECT_TRUE(beside->path.gaps.empty()) << beside->what();
  options.domain.keepOut = { { 7, 7, 7 } };
  EXPECT_FALSE(leakOf(cube(), options).has_value());
}

// The first search is too coarse for the gaps; the next one takes more memory than the least limit here.
TEST(KeepOut, TheSearchHasALimitAndStops)
{
  Rooms rooms;
  rooms.above = rooms.between = 0.04;
  rooms.build();
  const Bounds all{ { -1, -1, -1 }, { 3, 2, 3 } };
  Execution execution;
  const Surface surface = onLattice(rooms.soup.view(), Lattice(all), execution);
  Meshlines planes;
  for (std::size_t axis = 0; axis < 3; ++axis)
  {
    planes[axis] = { surface.lattice.vertex(int(axis), all.low[axis]) + 1,
      surface.lattice.vertex(int(axis), all.high[axis]) - 1 };
  }
  KeepPoint from;
  KeepPoint to;
  from.place = rooms.inside;
  to.place = rooms.outside;
  const auto pathWith = [&](double memory, Execution& with) {
    LeakSearch search(planes, 0, 1, memory);
    search.from = &from;
    search.to = &to;
    return findLeak(surface, search, with);
  };
  EXPECT_TRUE(pathWith(1e7, execution).points.empty());
  EXPECT_EQ(pathWith(1e9, execution).gaps.size(), 2U);
  Execution stopped(1, [](double fraction, const char*) { return fraction < 0.01; });
  stopped.stage("Leak", 0, 1);
  EXPECT_THROW(pathWith(1e9, stopped), Stopped);
}
