// Faces that are too concave are split into parts that have star triangulations.
#include "Lattice/StarPolygons.h"
#include "Lattice/Vector.h"

#include <algorithm>
#include <gtest/gtest.h>

#include <cmath>
#include <map>
#include <random>

using namespace cartesian;

namespace
{

FlatPolygon polygon(const std::vector<PlanePoint>& at)
{
  FlatPolygon p;
  p.at = at;
  for (std::size_t i = 0; i < at.size(); ++i)
  {
    p.nodes.push_back(static_cast<std::uint32_t>(i));
  }
  return p;
}

FlatPolygon hole(const std::vector<PlanePoint>& at, std::uint32_t firstNode)
{
  FlatPolygon p;
  for (std::size_t i = at.size(); i-- > 0;) // clockwise
  {
    p.at.push_back(at[i]);
    p.nodes.push_back(static_cast<std::uint32_t>(firstNode + i));
  }
  return p;
}

std::vector<PlanePoint> square(std::int64_t low, std::int64_t high)
{
  return { { low, low }, { high, low }, { high, high }, { low, high } };
}

Wide twiceArea(const std::vector<PlanePoint>& at)
{
  Wide sum = 0;
  for (std::size_t i = 1; i + 1 < at.size(); ++i)
  {
    sum += turn(at[0], at[i], at[i + 1]);
  }
  return sum;
}

// How often each edge is used in one direction, minus the other.
using Edges = std::map<std::pair<std::uint32_t, std::uint32_t>, int>;

void addEdges(const FlatPolygon& p, Edges& edges)
{
  for (std::size_t i = 0; i < p.nodes.size(); ++i)
  {
    const std::uint32_t from = p.nodes[i];
    const std::uint32_t to = p.nodes[(i + 1) % p.nodes.size()];
    edges[std::minmax(from, to)] += from < to ? 1 : -1;
  }
}

Edges withoutZeros(Edges edges)
{
  for (auto edge = edges.begin(); edge != edges.end();)
  {
    edge = edge->second == 0 ? edges.erase(edge) : std::next(edge);
  }
  return edges;
}

// In exact numbers: n times the centre is the sum of n corners.
bool isStarExactly(const std::vector<PlanePoint>& at)
{
  const auto n = static_cast<std::int64_t>(at.size());
  PlanePoint centre{ 0, 0 };
  for (const PlanePoint& p : at)
  {
    centre = { centre.a + p.a, centre.b + p.b };
  }
  for (std::size_t i = 0; i < at.size(); ++i)
  {
    const PlanePoint& p = at[i];
    const PlanePoint& q = at[(i + 1) % at.size()];
    if (turn(centre, { n * p.a, n * p.b }, { n * q.a, n * q.b }) < 0)
    {
      return false;
    }
  }
  return true;
}

std::vector<FlatPolygon> split(const FlatPolygon& whole)
{
  std::vector<FlatPolygon> parts;
  splitIntoStars(whole, parts);
  Wide area = 0;
  Edges edges;
  for (const FlatPolygon& part : parts)
  {
    EXPECT_GE(part.nodes.size(), 3U);
    EXPECT_EQ(part.nodes.size(), part.at.size());
    area += twiceArea(part.at);
    addEdges(part, edges);
  }
  EXPECT_TRUE(area == twiceArea(whole.at));
  Edges expected;
  addEdges(whole, expected);
  EXPECT_EQ(withoutZeros(edges), withoutZeros(expected));
  return parts;
}

void expectStars(const FlatPolygon& whole)
{
  for (const FlatPolygon& part : split(whole))
  {
    EXPECT_TRUE(isStarExactly(part.at));
    EXPECT_TRUE(twiceArea(part.at) > 0);
  }
}

std::vector<PlanePoint> comb(int teeth)
{
  std::vector<PlanePoint> at = { { 0, 0 }, { 20 * teeth, 0 } };
  for (int i = teeth; i-- > 0;)
  {
    at.push_back({ 20 * i + 20, 1000 });
    at.push_back({ 20 * i + 10, 1000 });
    at.push_back({ 20 * i + 10, 10 });
    at.push_back({ 20 * i, 10 });
  }
  return at;
}

std::vector<PlanePoint> spiral(int windings)
{
  std::vector<PlanePoint> outer;
  std::vector<PlanePoint> inner;
  for (int i = 0; i <= 4 * windings; ++i)
  {
    const std::int64_t r = 1000 - 1000 * i / (4 * windings + 2);
    const std::array<PlanePoint, 4> way = { { { 1, 1 }, { -1, 1 }, { -1, -1 }, { 1, -1 } } };
    outer.push_back({ way[i % 4].a * r, way[i % 4].b * r });
    inner.push_back({ way[i % 4].a * (r - 20), way[i % 4].b * (r - 20) });
  }
  outer.insert(outer.end(), inner.rbegin(), inner.rend());
  return outer;
}

// Corners at random distances, in order of their directions: simple, however spiky.
std::vector<PlanePoint> spiky(unsigned seed, int corners)
{
  std::mt19937 random(seed);
  std::uniform_real_distribution<double> radius(1e3, 1e9);
  std::vector<PlanePoint> at;
  for (int i = 0; i < corners; ++i)
  {
    const double r = radius(random);
    const double angle = 2 * Pi * i / corners;
    at.push_back({ std::llround(r * std::cos(angle)), std::llround(r * std::sin(angle)) });
  }
  return at;
}

}

TEST(StarPolygons, ConvexPolygonsStayWhole)
{
  for (const auto& at : { square(0, 10), square(0, 4000000000),
         std::vector<PlanePoint>{ { 0, 0 }, { 1000000000, 0 }, { 1000000000, 1 } },
         std::vector<PlanePoint>{ { 0, 0 }, { 5, 0 }, { 9, 0 }, { 9, 9 } } })
  {
    EXPECT_TRUE(isStar(at));
    EXPECT_EQ(split(polygon(at)).size(), 1U);
  }
}

TEST(StarPolygons, SlightlyConcavePolygonsStayWhole)
{
  EXPECT_EQ(
    split(polygon({ { 0, 0 }, { 50, 10 }, { 100, 0 }, { 100, 100 }, { 0, 100 } })).size(), 1U);
}

TEST(StarPolygons, LShapeIsSplitInTwo)
{
  const FlatPolygon l =
    polygon({ { 0, 0 }, { 100, 0 }, { 100, 10 }, { 10, 10 }, { 10, 100 }, { 0, 100 } });
  EXPECT_FALSE(isStar(l.at));
  expectStars(l);
  EXPECT_EQ(split(l).size(), 2U);
}

TEST(StarPolygons, Spiral)
{
  for (int windings = 1; windings < 8; ++windings)
  {
    expectStars(polygon(spiral(windings)));
  }
}

TEST(StarPolygons, Comb)
{
  for (const int teeth : { 2, 3, 10, 40 })
  {
    expectStars(polygon(comb(teeth)));
  }
}

TEST(StarPolygons, SpikyPolygons)
{
  for (unsigned seed = 0; seed < 30; ++seed)
  {
    expectStars(polygon(spiky(seed, 4 + static_cast<int>(seed))));
  }
}

TEST(StarPolygons, AHole)
{
  FlatPolygon p = polygon(square(0, 100));
  joinHoles(p, { hole(square(40, 60), 4) });
  EXPECT_EQ(p.nodes.size(), 10U);
  EXPECT_TRUE(twiceArea(p.at) == 2 * (100 * 100 - 20 * 20));
  expectStars(p);
}

// Bridges may end in corners where others end already, and must not cross holes to be joined later.
TEST(StarPolygons, SeveralHoles)
{
  FlatPolygon p = polygon(square(0, 1000));
  std::vector<FlatPolygon> holes;
  for (std::uint32_t i = 0; i < 9; ++i)
  {
    std::vector<PlanePoint> at = square(0, 150);
    for (PlanePoint& corner : at)
    {
      corner = { corner.a + 100 + 300 * (i % 3) + i, corner.b + 100 + 300 * (i / 3) + 2 * i };
    }
    holes.push_back(hole(at, 4 + 4 * i));
  }
  joinHoles(p, holes);
  EXPECT_TRUE(twiceArea(p.at) == 2 * (1000 * 1000 - 9 * 150 * 150));
  expectStars(p);
}

// A wide thin hole hides the others from the polygon's corners.
TEST(StarPolygons, HolesBehindHoles)
{
  FlatPolygon p = polygon(square(0, 1000));
  std::vector<FlatPolygon> holes;
  for (std::uint32_t i = 0; i < 9; ++i)
  {
    const std::int64_t low = 100 * i + 50;
    const std::int64_t inset = i % 2 == 0 ? 5 : 450;
    holes.push_back(hole(
      { { inset, low }, { 1000 - inset, low }, { 1000 - inset, low + 20 }, { inset, low + 20 } },
      4 + 4 * i));
  }
  joinHoles(p, holes);
  expectStars(p);
}

TEST(StarPolygons, ManyTriangularHoles)
{
  for (unsigned seed = 0; seed < 10; ++seed)
  {
    std::mt19937 random(seed);
    FlatPolygon p = polygon(square(0, 1000));
    std::vector<FlatPolygon> holes;
    for (std::uint32_t i = 0; i < 64; ++i)
    {
      const auto corner = [&](std::int64_t a, std::int64_t b) {
        return PlanePoint{ 100 + 100 * (i % 8) + a + static_cast<std::int64_t>(random() % 40),
          100 + 100 * (i / 8) + b + static_cast<std::int64_t>(random() % 40) };
      };
      const PlanePoint first = corner(0, 0);
      const PlanePoint second = corner(50, 0);
      holes.push_back(hole({ first, second, corner(20, 50) }, 4 + 3 * i));
    }
    std::shuffle(holes.begin(), holes.end(), random);
    joinHoles(p, holes);
    expectStars(p);
  }
}

// Two holes that share a corner with each other and one with the polygon.
TEST(StarPolygons, HolesThatTouchEachOther)
{
  FlatPolygon p = polygon(square(0, 100));
  FlatPolygon first = hole({ { 0, 0 }, { 50, 10 }, { 50, 20 } }, 4);
  FlatPolygon second = hole({ { 50, 20 }, { 60, 60 }, { 20, 60 } }, 7);
  FlatPolygon third = hole({ { 0, 0 }, { 20, 40 }, { 10, 40 } }, 10);
  first.nodes.back() = 0;
  second.nodes.back() = first.nodes.front(); // reversed: its last corner is the hole's first
  third.nodes.back() = 0;
  joinHoles(p, { first, second, third });
  EXPECT_EQ(p.nodes.size(), 13U);
  expectStars(p);
}

// The bridge would run from the corner to itself.
TEST(StarPolygons, AHoleThatTouchesACorner)
{
  FlatPolygon p = polygon(square(0, 100));
  FlatPolygon h = hole({ { 0, 0 }, { 50, 20 }, { 20, 50 } }, 4);
  h.nodes.back() = 0;
  joinHoles(p, { h });
  EXPECT_EQ(p.nodes.size(), 7U);
  expectStars(p);
}

// Rounding may make a face intersect itself: its parts may be bad, but nothing gets lost.
TEST(StarPolygons, PolygonsThatCrossThemselves)
{
  std::mt19937 random(1);
  for (const std::int64_t width : { 3L, 10L, 1000L, 4000000000L })
  {
    std::uniform_int_distribution<std::int64_t> level(0, width);
    for (int i = 0; i < 100; ++i)
    {
      std::vector<PlanePoint> at(static_cast<std::size_t>(3 + i % 20));
      for (PlanePoint& p : at)
      {
        p = { level(random), level(random) };
      }
      split(polygon(at));
    }
  }
}

TEST(StarPolygons, PolygonsWithoutArea)
{
  split(polygon({ { 0, 0 }, { 10, 0 }, { 20, 0 }, { 5, 0 } }));
  split(polygon({ { 7, 7 }, { 7, 7 }, { 7, 7 }, { 7, 7 }, { 7, 7 } }));
}
