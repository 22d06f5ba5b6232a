// Gaps that are meant to be closed: windows in the walls of boxes, whose areas are known.
#include "Mesher/ClosedGaps.h"

#include "Support/Effort.h"
#include "Support/MeshChecker.h"

#include <gtest/gtest.h>

#include <cmath>
#include <map>
#include <numeric>
#include <random>

using namespace cartesian;

namespace
{

constexpr std::int32_t FirstGap = 100;

struct Windowed
{
  Soup open;                                // boundaries 0 to 5, as those of a box
  std::map<std::uint32_t, double> windowAt; // area, by any point of the rim
  double wall = 0;                          // area of what is left
  double volume = 0;
};

// The sides of a box, in rectangles, with a window of several in some of them that does not reach their edges.
Windowed windowed(unsigned seed)
{
  std::mt19937 random(seed);
  std::uniform_real_distribution<double> step(0.2, 0.5);
  std::array<std::vector<double>, 3> lines;
  for (std::vector<double>& along : lines)
  {
    along.push_back(0);
    for (int i = 0; i < 5; ++i)
    {
      along.push_back(along.back() + step(random));
    }
  }
  Windowed result;
  result.volume = lines[0].back() * lines[1].back() * lines[2].back();
  for (std::size_t axis = 0; axis < 3; ++axis)
  {
    const std::size_t u = (axis + 1) % 3;
    const std::size_t v = (axis + 2) % 3;
    for (const std::size_t side : { 0U, 5U })
    {
      const bool hasWindow = random() % 2 == 0 || axis + side == 0;
      std::array<std::size_t, 4> window{}; // from, to along u and v
      for (const std::size_t i : { 0U, 2U })
      {
        window[i] = 1 + random() % 3;
        window[i + 1] = window[i] + 1 + random() % (4 - window[i]);
      }
      const auto pointAt = [&](std::size_t i, std::size_t j) {
        Vector p{};
        p[axis] = lines[axis][side];
        p[u] = lines[u][i];
        p[v] = lines[v][j];
        result.open.points.push_back(p);
        return static_cast<std::uint32_t>(result.open.points.size() - 1);
      };
      const double area =
        (lines[u][window[1]] - lines[u][window[0]]) * (lines[v][window[3]] - lines[v][window[2]]);
      const auto boundary = static_cast<std::int32_t>(2 * axis + (side > 0 ? 1 : 0));
      for (std::size_t i = 0; i < 5; ++i)
      {
        for (std::size_t j = 0; j < 5; ++j)
        {
          const std::array<std::uint32_t, 4> c{ pointAt(i, j), pointAt(i + 1, j),
            pointAt(i + 1, j + 1), pointAt(i, j + 1) };
          const auto isIn = [&](std::size_t a, std::size_t b, std::size_t touch) {
            return a + touch >= window[0] && a < window[1] + touch && b + touch >= window[2] &&
              b < window[3] + touch;
          };
          if (hasWindow && isIn(i, j, 0))
          {
            continue;
          }
          if (hasWindow && isIn(i, j, 1))
          {
            for (const std::uint32_t point : c)
            {
              result.windowAt[point] = area;
            }
          }
          result.open.triangles.push_back({ c[0], c[1], c[2] });
          result.open.triangles.push_back({ c[0], c[2], c[3] });
          result.open.boundary.insert(result.open.boundary.end(), 2, boundary);
          result.wall += (lines[u][i + 1] - lines[u][i]) * (lines[v][j + 1] - lines[v][j]);
        }
      }
    }
  }
  return result;
}

ClosedGaps closed(const Soup& soup, double cellSize, double width, int depth = 0)
{
  Options options;
  options.depthAtSurface = depth;
  options.grid = cellsOf(cellSize);
  options.closeGaps = width;
  Execution execution;
  return closedGaps(soup.view(), options, execution);
}

std::vector<ClosedGap> gapsOf(const Soup& soup, double cellSize, double width, int depth = 0)
{
  return closed(soup, cellSize, width, depth).gaps;
}

void addRectangle(const std::array<Vector, 4>& corners, Soup& soup)
{
  const auto first = static_cast<std::uint32_t>(soup.points.size());
  soup.points.insert(soup.points.end(), corners.begin(), corners.end());
  soup.triangles.push_back({ first, first + 1, first + 2 });
  soup.triangles.push_back({ first, first + 2, first + 3 });
}

// A box whose top has a window, from 0.3 to 0.7 of its sides.
void addOpenBox(double low, double high, Soup& soup)
{
  const std::array<double, 4> lines{ 0, 0.3, 0.7, 1 };
  for (std::size_t axis = 0; axis < 3; ++axis)
  {
    for (const double side : { 0., 1. })
    {
      for (std::size_t i = 0; i < 9; ++i)
      {
        const auto at = [&](std::size_t u, std::size_t v) {
          Vector p{};
          p[axis] = side;
          p[(axis + 1) % 3] = lines[i / 3 + u];
          p[(axis + 2) % 3] = lines[i % 3 + v];
          return plus({ low, low, low }, scaled(p, high - low));
        };
        if (axis != 2 || side == 0 || i != 4)
        {
          addRectangle({ at(0, 0), at(1, 0), at(1, 1), at(0, 1) }, soup);
        }
      }
    }
  }
}

// Of the window of that box.
Vector cornerOfWindow(std::size_t corner, double low, double high)
{
  const std::array<std::array<double, 2>, 4> corners{ { { 0.3, 0.3 }, { 0.7, 0.3 }, { 0.7, 0.7 },
    { 0.3, 0.7 } } };
  const auto& [u, v] = corners[corner % 4];
  return plus({ low, low, low }, scaled({ u, v, 1 }, high - low));
}

Soup with(const Soup& open, const std::vector<ClosedGap>& gaps)
{
  Soup closed = open;
  for (std::size_t i = 0; i < gaps.size(); ++i)
  {
    closed.triangles.insert(
      closed.triangles.end(), gaps[i].triangles.begin(), gaps[i].triangles.end());
    closed.boundary.resize(closed.triangles.size(), FirstGap + static_cast<std::int32_t>(i));
    if (!closed.region.empty())
    {
      closed.region.resize(closed.triangles.size(), gaps[i].region);
    }
  }
  return closed;
}

void expectClosed(const Windowed& body, const Soup& open, double cellSize, unsigned seed)
{
  SCOPED_TRACE(seed);
  const std::vector<ClosedGap> gaps = gapsOf(open, cellSize, 2);
  ASSERT_FALSE(gaps.empty());
  const Soup whole = with(open, gaps);
  double all = 0;
  for (std::size_t i = 0; i < gaps.size(); ++i)
  {
    double area = 0;
    for (std::size_t t = 0; t < whole.triangles.size(); ++t)
    {
      area += whole.boundaryOf(t) == FirstGap + static_cast<std::int32_t>(i) ? whole.area(t) : 0;
    }
    EXPECT_NEAR(area, body.windowAt.at(gaps[i].rim.front()), 1e-9);
    all += area;
  }
  EXPECT_NEAR(whole.area(), body.wall + all, 1e-9);
  EXPECT_NEAR(std::abs(whole.volume()), body.volume, 1e-9);
  const PreparedSurface prepared = prepare(whole, cellsOf(cellSize));
  EXPECT_TRUE(prepared.repair.check.closed());
}

}

TEST(ClosedGaps, WindowsOfBoxes)
{
  for (unsigned seed = 0; seed < repeats(40); ++seed)
  {
    const Windowed body = windowed(seed);
    const double cellSize = std::array{ 0.03, 0.06, 0.11 }[seed % 3];
    expectClosed(body, body.open, cellSize, seed);
    expectClosed(body, body.open.turned(int(seed % 3), 45), cellSize, seed);
    expectClosed(body, body.open.turned(), cellSize, seed);
  }
}

TEST(ClosedGaps, TheMeshFillsThem)
{
  for (const unsigned seed : cases({ 0U, 1U, 2U, 3U }))
  {
    const Windowed body = windowed(seed);
    const std::array<Soup, 4> turns{ body.open, body.open.turned(2, 45), body.open.turned(0, 30),
      body.open.turned() };
    const Soup& open = turns[seed];
    const Soup whole = with(open, gapsOf(open, 0.11, 2));
    const MeshArrays mesh = meshOf(whole, cellsOf(0.11)).mesh;
    EXPECT_TRUE(isValid(mesh));
    EXPECT_TRUE(fills(mesh, whole)) << seed;
  }
}

TEST(ClosedGaps, NoneThatIsWiderOrNarrower)
{
  const Windowed body = windowed(3);
  const std::vector<ClosedGap> all = gapsOf(body.open, 0.05, 5);
  ASSERT_GT(all.size(), 1U);
  double widest = 0;
  for (const ClosedGap& gap : all)
  {
    widest = std::max(widest, gap.width);
  }
  EXPECT_TRUE(gapsOf(body.open, 0.05, 0).empty());
  EXPECT_EQ(gapsOf(body.open, 0.05, widest).size(), all.size());
  EXPECT_EQ(gapsOf(body.open, 0.05, 0.999 * widest).size(), all.size() - 1);
  // In boxes as wide as they are, they are holes like others; not if these may be halved.
  EXPECT_TRUE(gapsOf(body.open, 1.001 * widest, 5).empty());
  EXPECT_EQ(gapsOf(body.open, 1.001 * widest, 5, 1).size(),
    gapsOf(body.open, 1.001 * widest / 2, 5).size());
}

TEST(ClosedGaps, EachRegionByItself)
{
  const Windowed one = windowed(0);
  const Windowed other = windowed(1);
  Soup both;
  both.addRegion(one.open);
  both.addRegion(other.open.moved({ 3, 0, 0 }));
  const Soup whole = with(both, gapsOf(both, 0.11, 2));
  const std::map<int, double> volumes = volumesByRegion(meshOf(whole, cellsOf(0.11)).mesh);
  ASSERT_EQ(volumes.size(), 2U);
  EXPECT_NEAR(volumes.begin()->second, one.volume, 1e-6);
  EXPECT_NEAR(volumes.rbegin()->second, other.volume, 1e-6);
}

// The skin and the lining of a wall, joined around a window, which a pane closes on the outside.
TEST(ClosedGaps, APaneIsASheet)
{
  for (const bool hasPane : { true, false })
  {
    Soup wall;
    addOpenBox(0, 1, wall);
    addOpenBox(0.1, 0.9, wall);
    for (std::size_t i = 0; i < 4; ++i)
    {
      addRectangle({ cornerOfWindow(i, 0, 1), cornerOfWindow(i + 1, 0, 1),
                     cornerOfWindow(i + 1, 0.1, 0.9), cornerOfWindow(i, 0.1, 0.9) },
        wall);
    }
    const auto pane = static_cast<std::uint32_t>(wall.triangles.size());
    if (hasPane)
    {
      addRectangle({ cornerOfWindow(0, 0, 1), cornerOfWindow(1, 0, 1), cornerOfWindow(2, 0, 1),
                     cornerOfWindow(3, 0, 1) },
        wall);
    }
    const ClosedGaps found = closed(wall.turned(), 0.06, 1);
    EXPECT_TRUE(found.gaps.empty());
    EXPECT_EQ(found.panes,
      hasPane ? std::vector<std::uint32_t>({ pane, pane + 1 }) : std::vector<std::uint32_t>());
  }
}

// Whose sides are a hair apart: they are no gaps.
TEST(ClosedGaps, WindowsOfBoxesThatFellApart)
{
  constexpr double Crack = 1e-5;
  for (unsigned seed = 0; seed < repeats(12); ++seed)
  {
    SCOPED_TRACE(seed);
    const Windowed body = windowed(seed);
    Soup apart = body.open;
    std::map<std::uint32_t, std::int32_t> sides;
    for (std::size_t t = 0; t < apart.triangles.size(); ++t)
    {
      for (const std::uint32_t point : apart.triangles[t])
      {
        sides[point] = apart.boundaryOf(t);
      }
    }
    for (const auto& [point, side] : sides)
    {
      apart.points[point][static_cast<std::size_t>(side / 2)] += side % 2 == 0 ? -Crack : Crack;
    }
    const std::size_t windows = gapsOf(body.open, 0.06, 2).size();
    const std::vector<ClosedGap> gaps = gapsOf(apart, 0.06, 2);
    EXPECT_EQ(gaps.size(), windows);
    const PreparedSurface prepared = prepare(with(apart, gaps), cellsOf(0.06));
    EXPECT_TRUE(prepared.repair.check.closed());
    EXPECT_NEAR(volumeOf(prepared.surface), body.volume, 2 * Crack * body.wall);
  }
}

namespace
{

using Chain = std::vector<Vector>;

// The triangles between an edge and a chain that runs along it, in a plane.
void addBetween(const Vector& from, const Vector& to, const Chain& chain, Soup& soup)
{
  const auto first = static_cast<std::uint32_t>(soup.points.size());
  soup.points.push_back(from);
  soup.points.insert(soup.points.end(), chain.begin(), chain.end());
  soup.points.push_back(to);
  for (auto p = first + 1; p + 1 < soup.points.size(); ++p)
  {
    soup.triangles.push_back({ first, p, p + 1 });
  }
}

// A side of a rim, with random places between its ends.
Chain divided(const Vector& from, const Vector& to, std::mt19937& random)
{
  std::vector<double> parts{ 0, 1 };
  for (auto more = random() % 12; more > 0; --more)
  {
    parts.push_back(std::uniform_real_distribution<double>(0.02, 0.98)(random));
  }
  std::sort(parts.begin(), parts.end());
  Chain chain;
  for (const double part : parts)
  {
    chain.push_back(plus(scaled(from, 1 - part), scaled(to, part)));
  }
  return chain;
}

using Corners4 = std::array<Vector, 4>;

// A rectangle at a height, the corners from one in turn.
Corners4 rectangleAt(double z, const Vector& low, const Vector& high)
{
  return { { { low[0], low[1], z }, { high[0], low[1], z }, { high[0], high[1], z },
    { low[0], high[1], z } } };
}

// Walls around, from the first rectangle to a rim at the second.
void addWalls(const Corners4& from, const Corners4& rim, std::mt19937& random, Soup& soup)
{
  for (std::size_t i = 0; i < 4; ++i)
  {
    const std::size_t next = (i + 1) % 4;
    addBetween(from[i], from[next], divided(rim[i], rim[next], random), soup);
  }
}

// An end of a box and its walls.
void addHalf(const Corners4& end, const Corners4& rim, std::mt19937& random, Soup& soup)
{
  Soup half;
  addRectangle(end, half);
  addWalls(end, rim, random, half);
  soup.add(rim[0][2] > end[0][2] ? half.flipped() : half);
}

// A box from 0 to `size`, cut all around by a gap at half its height.
Soup halves(const Vector& size, double gap, std::mt19937& random)
{
  Soup soup;
  for (const bool isUpper : { false, true })
  {
    const Corners4 end = rectangleAt(isUpper ? size[2] : 0, { 0, 0, 0 }, size);
    const double rim = size[2] / 2 + (isUpper ? gap : -gap) / 2;
    addHalf(end, rectangleAt(rim, { 0, 0, 0 }, size), random, soup);
  }
  return soup;
}

// Cut twice, aslant: the gap is from 0.6 to 1.4 times as wide. `at`: its place, a part of the height.
Soup halvesAslant(const Vector& size, double gap, double at, std::mt19937& random)
{
  Soup soup;
  std::uniform_real_distribution<double> by(-0.2 * gap, 0.2 * gap);
  const double tilt = std::uniform_real_distribution<double>(-0.2, 0.2)(random) * size[2];
  for (const bool isUpper : { false, true })
  {
    const Corners4 end = rectangleAt(isUpper ? size[2] : 0, { 0, 0, 0 }, size);
    Corners4 rim = rectangleAt(at * size[2] + (isUpper ? gap : -gap) / 2, { 0, 0, 0 }, size);
    const double moreAtZero = by(random);
    const double moreAtOne = by(random);
    for (Vector& corner : rim)
    {
      const double part = corner[0] / size[0];
      corner[2] += tilt * (part - 0.5) + moreAtZero * (1 - part) + moreAtOne * part;
    }
    addHalf(end, rim, random, soup);
  }
  return soup;
}

// Corners of a polygon in a circle, in turn.
Chain roundOf(double radius, double z, const std::vector<double>& angles)
{
  Chain chain;
  for (const double angle : angles)
  {
    chain.push_back({ radius * std::cos(angle), radius * std::sin(angle), z });
  }
  return chain;
}

// At most twice as far apart as they are on average.
std::vector<double> anglesAround(std::size_t count, std::mt19937& random)
{
  std::vector<double> angles;
  for (std::size_t i = 0; i < count; ++i)
  {
    const double in = std::uniform_real_distribution<double>(0.05, 0.95)(random);
    angles.push_back(2 * Pi * (double(i) + in) / double(count));
  }
  return angles;
}

double areaOfPolygon(const Chain& chain)
{
  double area = 0;
  for (std::size_t i = 0; i < chain.size(); ++i)
  {
    area += cross(chain[i], chain[(i + 1) % chain.size()])[2] / 2;
  }
  return area;
}

struct Can
{
  Soup open;
  double area; // of the whole
  double volume;
};

// A prism of height 1 over a polygon in a circle of radius 1 with a lid in its top, between which and the frame are from 0.02 to 0.3.
Can canWithLid(std::mt19937& random)
{
  const std::vector<double> angles = anglesAround(16 + random() % 20, random);
  const double hole = 0.8;
  const double lid = std::uniform_real_distribution<double>(0.55, 0.72)(random);
  const std::array<Chain, 3> around{ roundOf(1, 0, angles), roundOf(1, 1, angles),
    roundOf(hole, 1, angles) };
  const Chain rim = roundOf(lid, 1, anglesAround(16 + random() % 60, random));
  Can can{ {}, 0, areaOfPolygon(around[0]) };
  for (std::size_t i = 0; i < angles.size(); ++i)
  {
    const std::size_t next = (i + 1) % angles.size();
    addRectangle({ around[0][i], around[0][next], around[1][next], around[1][i] }, can.open);
    addRectangle({ around[1][i], around[1][next], around[2][next], around[2][i] }, can.open);
    addBetween({ 0, 0, 0 }, { 0, 0, 0 }, { around[0][next], around[0][i] }, can.open);
    can.area += norm(minus(around[0][next], around[0][i]));
  }
  for (std::size_t i = 0; i < rim.size(); ++i)
  {
    addBetween({ 0, 0, 1 }, { 0, 0, 1 }, { rim[i], rim[(i + 1) % rim.size()] }, can.open);
  }
  can.area += 2 * can.volume;
  return can;
}

// A box with rectangular lids in its top, so many each way, between which and around which are slots.
Soup boxWithLids(const Vector& size, std::size_t count, double gap, std::mt19937& random)
{
  const double border = 0.1 * size[0];
  const Corners4 top = rectangleAt(size[2], { 0, 0, 0 }, size);
  const Vector low{ border, border, 0 };
  const Vector high = minus(size, low);
  Soup soup;
  const Corners4 bottom = rectangleAt(0, { 0, 0, 0 }, size);
  addRectangle({ bottom[0], bottom[3], bottom[2], bottom[1] }, soup);
  for (std::size_t i = 0; i < 4; ++i)
  {
    addRectangle({ bottom[i], bottom[(i + 1) % 4], top[(i + 1) % 4], top[i] }, soup);
  }
  Soup frame;
  addWalls(top, rectangleAt(size[2], low, high), random, frame);
  soup.add(frame.flipped());
  for (std::size_t n = 0; n < count * count; ++n)
  {
    Vector from{};
    Vector to{};
    for (const std::size_t axis : { 0U, 1U })
    {
      const double each = (high[axis] - low[axis] - gap) / double(count);
      from[axis] = low[axis] + gap + each * double(axis == 0 ? n / count : n % count);
      to[axis] = from[axis] + each - gap;
    }
    const Vector middle{ (from[0] + to[0]) / 2, (from[1] + to[1]) / 2, size[2] };
    addWalls({ { middle, middle, middle, middle } }, rectangleAt(size[2], from, to), random, soup);
  }
  return soup;
}

double volumeOfBox(const Vector& size)
{
  return size[0] * size[1] * size[2];
}

double areaOfBox(const Vector& size)
{
  return 2 * (size[0] * size[1] + size[1] * size[2] + size[2] * size[0]);
}

struct Body
{
  double area;
  double volume;
  double
    gap; // at edges of the body where both rims are aslant, less of it than that, cubed, may be cut off
};

void expectBody(const Soup& whole, const Body& body, double cellSize)
{
  EXPECT_LE(whole.area(), body.area * (1 + 1e-9));
  EXPECT_GE(whole.area(), body.area * (1 - 1e-9) - body.gap * body.gap);
  const PreparedSurface prepared = prepare(whole, cellsOf(cellSize));
  EXPECT_TRUE(prepared.repair.check.closed());
  EXPECT_NEAR(volumeOf(prepared.surface), body.volume, 1e-7 * body.volume + std::pow(body.gap, 3));
}

// Returns the width of the gap.
double expectClosedByOne(const Soup& open, const Body& body, double cellSize, double widest)
{
  const std::vector<ClosedGap> gaps = gapsOf(open, cellSize, widest);
  EXPECT_EQ(gaps.size(), 1U);
  const Soup whole = with(open, gaps);
  expectBody(whole, body, cellSize);
  EXPECT_TRUE(prepare(whole, cellsOf(cellSize)).repair.pairs.pairs.empty());
  return gaps.empty() ? 0 : gaps[0].width;
}

const std::vector<Vector> Sizes{ { 1, 1.3, 0.8 }, { 40, 30, 20 }, { 0.02, 0.012, 0.01 } };

std::array<Soup, 4> turnsOf(const Soup& soup)
{
  return { soup, soup.turned(2, 45), soup.turned(0, 30), soup.turned() };
}

}

TEST(ClosedGaps, ABoxCutAllAround)
{
  std::mt19937 random(1);
  for (const Vector& size : Sizes)
  {
    for (const double part : { 0.02, 0.07, 0.2 })
    {
      const double gap = part * size[2];
      for (const Soup& open : turnsOf(halves(size, gap, random)))
      {
        SCOPED_TRACE(testing::Message() << size[0] << " " << part);
        const Body body{ areaOfBox(size), volumeOfBox(size), 0 };
        EXPECT_NEAR(expectClosedByOne(open, body, 0.9 * gap, 1.05 * gap), gap, 1e-6 * gap);
      }
    }
  }
}

TEST(ClosedGaps, ALidInAFrame)
{
  std::mt19937 random(2);
  for (const Vector& size : Sizes)
  {
    for (const double part : { 0.02, 0.07, 0.2 })
    {
      const double gap = part * size[2];
      for (const Soup& open : turnsOf(boxWithLids(size, 1, gap, random)))
      {
        SCOPED_TRACE(testing::Message() << size[0] << " " << part);
        const Body body{ areaOfBox(size), volumeOfBox(size), 0 };
        EXPECT_NEAR(expectClosedByOne(open, body, 0.9 * gap, 1.05 * gap), gap, 1e-6 * gap);
      }
    }
  }
}

TEST(ClosedGaps, StripsOfRandomCuts)
{
  for (unsigned seed = 0; seed < repeats(200); ++seed)
  {
    SCOPED_TRACE(seed);
    std::mt19937 random(seed);
    std::uniform_real_distribution<double> side(0.5, 2);
    const Vector size{ side(random), side(random), side(random) };
    const double gap = std::uniform_real_distribution<double>(0.02, 0.2)(random) * size[2];
    const double at = std::uniform_real_distribution<double>(0.35, 0.65)(random);
    const Soup open = halvesAslant(size, gap, at, random);
    expectClosedByOne(
      turnsOf(open)[seed % 4], { areaOfBox(size), volumeOfBox(size), gap }, gap / 4, 1.5 * gap);
    const Can can = canWithLid(random);
    expectClosedByOne(turnsOf(can.open)[seed / 4 % 4], { can.area, can.volume, 0 }, 0.02, 0.3);
  }
}

// What is left where slots meet is closed with one of them.
TEST(ClosedGaps, LidsSideBySide)
{
  const Vector size{ 1, 1.2, 0.7 };
  for (unsigned seed = 0; seed < repeats(40); ++seed)
  {
    SCOPED_TRACE(seed);
    std::mt19937 random(seed);
    const double gap = std::uniform_real_distribution<double>(0.01, 0.05)(random);
    const Soup open = turnsOf(boxWithLids(size, 2 + seed % 2, gap, random))[seed / 2 % 4];
    const std::vector<ClosedGap> gaps = gapsOf(open, gap / 2, 2.1 * gap);
    expectBody(with(open, gaps), { areaOfBox(size), volumeOfBox(size), 0 }, gap / 2);
  }
}

TEST(ClosedGaps, TheMeshFillsStrips)
{
  std::mt19937 random(3);
  const Vector size{ 1, 1.3, 0.8 };
  const std::array<Soup, 4> shapes{ halves(size, 0.1, random), boxWithLids(size, 1, 0.08, random),
    boxWithLids(size, 2, 0.08, random), canWithLid(random).open };
  for (const std::size_t i : cases({ 0U, 1U, 2U, 3U }))
  {
    const Soup open = turnsOf(shapes[i])[i];
    const Soup whole = with(open, gapsOf(open, 0.06, 0.3));
    const MeshArrays mesh = meshOf(whole, cellsOf(0.06)).mesh;
    EXPECT_TRUE(isValid(mesh));
    EXPECT_TRUE(fills(mesh, whole));
  }
}

// Wider than asked, or narrower than a box.
TEST(ClosedGaps, NoOtherStrips)
{
  std::mt19937 random(4);
  const Soup open = halves({ 1, 1.3, 0.8 }, 0.1, random);
  EXPECT_EQ(gapsOf(open, 0.09, 0.101).size(), 1U);
  EXPECT_TRUE(gapsOf(open, 0.09, 0.099).empty());
  const Soup withLid = boxWithLids({ 1, 1.3, 0.8 }, 1, 0.1, random);
  EXPECT_TRUE(gapsOf(withLid, 0.11, 0.2).empty());
  EXPECT_EQ(gapsOf(withLid, 0.11, 0.2, 1).size(), 1U);
}

// The slot around a door with hinges is one loop: a hole twice as wide.
TEST(ClosedGaps, ADoorCutOnThreeSides)
{
  constexpr double Slot = 0.03;
  const std::array<double, 6> across{ 0, 0.2, 0.2 + Slot, 0.6, 0.6 + Slot, 1 };
  const std::array<double, 5> up{ 0, 0.1, 0.7, 0.7 + Slot, 1 };
  Soup open;
  const Soup whole = box({ 0, 0, 0 }, { 1, 1, 1 });
  open.points = whole.points;
  for (std::size_t t = 0; t < whole.triangles.size(); ++t)
  {
    if (whole.boundary[t] != 0)
    {
      open.triangles.push_back(whole.triangles[t]);
    }
  }
  for (std::size_t n = 0; n < 20; ++n)
  {
    const std::size_t i = n / 4;
    const std::size_t j = n % 4;
    const bool isSlot = (j == 1 && (i == 1 || i == 3)) || (j == 2 && i > 0 && i < 4);
    if (!isSlot)
    {
      addRectangle({ { { 0, across[i], up[j] }, { 0, across[i], up[j + 1] },
                     { 0, across[i + 1], up[j + 1] }, { 0, across[i + 1], up[j] } } },
        open);
    }
  }
  const double length = 0.43 + 2 * 0.6;
  const double width = 4 * length * Slot / (2 * length + 2 * Slot);
  for (const Soup& turned : turnsOf(open))
  {
    const std::vector<ClosedGap> gaps = gapsOf(turned, Slot, 2 * Slot);
    ASSERT_EQ(gaps.size(), 1U);
    EXPECT_NEAR(gaps[0].width, width, 1e-6);
    expectBody(with(turned, gaps), { 6, 1, 0 }, Slot);
    EXPECT_TRUE(gapsOf(turned, Slot, 1.5 * Slot).empty());
  }
}

// Each region has its own, whatever the order of points and triangles.
TEST(ClosedGaps, StripsInAnyOrder)
{
  std::mt19937 random(5);
  const Vector size{ 1, 1.3, 0.8 };
  Soup given;
  given.addRegion(halves(size, 0.1, random));
  given.addRegion(boxWithLids(size, 2, 0.08, random).moved({ 1.2, 0, 0 }));
  const auto placesOf = [&](const Soup& soup) {
    std::vector<std::vector<std::array<Vector, 3>>> places;
    for (const ClosedGap& gap : gapsOf(soup, 0.06, 0.2))
    {
      std::vector<std::array<Vector, 3>>& triangles = places.emplace_back();
      for (const auto& [a, b, c] : gap.triangles)
      {
        triangles.push_back({ soup.points[a], soup.points[b], soup.points[c] });
      }
    }
    return places;
  };
  const auto places = placesOf(given);
  EXPECT_GT(places.size(), 4U);
  const Soup closed = with(given, gapsOf(given, 0.06, 0.2));
  for (const auto& [region, volume] : volumesByRegion(meshOf(closed, cellsOf(0.06)).mesh))
  {
    EXPECT_NEAR(volume, volumeOfBox(size), 1e-6) << region;
  }
  Soup shuffled = given;
  std::vector<std::uint32_t> order(given.triangles.size());
  std::iota(order.begin(), order.end(), 0U);
  std::shuffle(order.begin(), order.end(), random);
  for (std::size_t t = 0; t < order.size(); ++t)
  {
    const auto& [a, b, c] = given.triangles[order[t]];
    shuffled.triangles[t] = { b, c, a };
    shuffled.region[t] = given.region[order[t]];
  }
  EXPECT_EQ(placesOf(shuffled), places);
}

// Plates side by side in a box: between sheets of type baffle it is no gap.
TEST(ClosedGaps, BafflesStayApart)
{
  Soup soup = box({ 0, 0, 0 }, { 1, 1, 1 });
  for (const double from : { 0.2, 0.53 })
  {
    const Corners4 plate = rectangleAt(0.5, { from, 0.2, 0 }, { from + 0.28, 0.8, 0 });
    addRectangle(plate, soup);
    soup.boundary.resize(soup.triangles.size(), 6);
  }
  Options options;
  options.grid = cellsOf(0.04);
  options.closeGaps = 0.1;
  Execution execution;
  const ClosedGaps found = closedGaps(soup.view(), options, execution);
  ASSERT_EQ(found.gaps.size(), 1U);
  EXPECT_NEAR(found.gaps[0].width, 0.05, 1e-6);
  options.baffles.push_back({ 6, 6 });
  EXPECT_TRUE(closedGaps(soup.view(), options, execution).gaps.empty());
}
