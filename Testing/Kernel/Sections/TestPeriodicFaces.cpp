// Two sides of a mesh get the same faces: cells stay closed and keep their volume, pairs of faces agree to rounding.
#include "Base/Error.h"
#include "Quality/FaceCorners.h"
#include "Sections/PeriodicFaces.h"
#include "Sections/PlanePolygons.h"
#include "Sections/SidePlane.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <map>
#include <random>

using namespace cartesian;

namespace
{

// A mesh, and faces on either side of it.
struct Slabs
{
  CellFaces cells;
  std::vector<double> points;
  std::array<std::vector<std::size_t>, 2> sides;
};

// Quadrangles and triangles that divide the unit square; points within it stand off a grid's by up to a part of its cells.
PlanePolygons divided(std::size_t n, std::size_t m, double jitter, unsigned seed)
{
  std::mt19937 random(seed);
  std::uniform_real_distribution<double> aside(-jitter, jitter);
  PlanePolygons all;
  for (std::size_t j = 0; j <= m; ++j)
  {
    for (std::size_t i = 0; i <= n; ++i)
    {
      const double u = i > 0 && i < n ? aside(random) : 0;
      const double v = j > 0 && j < m ? aside(random) : 0;
      all.points.push_back({ (double(i) + u) / double(n), (double(j) + v) / double(m) });
    }
  }
  const auto add = [&](std::initializer_list<std::size_t> corners) {
    for (const std::size_t corner : corners)
    {
      all.corners.push_back(static_cast<std::uint32_t>(corner));
    }
    all.firstCorner.push_back(all.corners.size());
  };
  for (std::size_t j = 0; j < m; ++j)
  {
    for (std::size_t i = 0; i < n; ++i)
    {
      const std::size_t p = j * (n + 1) + i;
      const std::size_t q = p + n + 1;
      if (random() % 3 == 0)
      {
        add({ p, p + 1, q + 1 });
        add({ p, q + 1, q });
      }
      else
      {
        add({ p, p + 1, q + 1, q });
      }
    }
  }
  return all;
}

// A prism on each polygon. `side`: 0, its lower faces are the first side, or 1, its upper ones the second. `low`, `high`: what
// gives points their third coordinates.
void addSlab(const PlanePolygons& base, std::size_t side, double low, double high, Slabs& slabs)
{
  const auto first = static_cast<std::uint32_t>(slabs.points.size() / 3);
  const auto count = static_cast<std::uint32_t>(base.points.size());
  for (const double z : { low, high })
  {
    for (const PlanePlace& p : base.points)
    {
      slabs.points.insert(slabs.points.end(), { p[0], p[1], z });
    }
  }
  CellFaces& cells = slabs.cells;
  const auto addFace = [&](const std::vector<std::uint32_t>& corners) {
    cells.firstCorner.push_back(cells.corners.size());
    for (const std::uint32_t corner : corners)
    {
      cells.corners.push_back(first + corner);
    }
  };
  for (std::size_t p = 0; p < base.count(); ++p)
  {
    cells.firstFace.push_back(cells.firstCorner.size());
    std::vector<std::uint32_t> lower;
    std::vector<std::uint32_t> upper;
    for (std::size_t i = 0; i < base.size(p); ++i)
    {
      const std::uint32_t a = base.corner(p, i);
      const std::uint32_t b = base.corner(p, i + 1);
      lower.insert(lower.begin(), a);
      upper.push_back(count + a);
      addFace({ a, b, count + b, count + a });
    }
    slabs.sides[side].push_back(cells.firstCorner.size() + (side == 0 ? 0 : 1));
    addFace(lower);
    addFace(upper);
  }
}

Slabs slabsOf(const PlanePolygons& a, const PlanePolygons& b)
{
  Slabs slabs;
  addSlab(a, 0, 0, 1, slabs);
  addSlab(b, 1, 2, 3, slabs);
  slabs.cells.firstFace.push_back(slabs.cells.firstCorner.size());
  slabs.cells.firstCorner.push_back(slabs.cells.corners.size());
  return slabs;
}

SideMotion upwards()
{
  SideMotion motion;
  motion.translation = { 0, 0, 3 };
  return motion;
}

PeriodicFaces matched(const Slabs& slabs, const SideMotion& motion = upwards())
{
  return matchSides(slabs.cells, slabs.points, slabs.sides, motion);
}

Vector pointAt(const std::vector<double>& points, std::size_t p)
{
  return { points[3 * p], points[3 * p + 1], points[3 * p + 2] };
}

double volumeOf(const CellFaces& cells, const std::vector<double>& points)
{
  std::vector<FaceGeometry> faces;
  const FaceCorners corners(cells, points.data());
  double volume = 0;
  for (std::size_t cell = 0; cell < cells.cellCount(); ++cell)
  {
    const double own = corners.geometryOfCell(cell, faces).volume;
    EXPECT_GT(own, 0) << cell;
    volume += own;
  }
  return volume;
}

// Each edge of a cell is there as often in either direction.
void expectClosed(const CellFaces& cells)
{
  for (std::size_t cell = 0; cell < cells.cellCount(); ++cell)
  {
    std::map<std::array<std::uint32_t, 2>, int> edges;
    for (std::size_t f = cells.firstFace[cell]; f < cells.firstFace[cell + 1]; ++f)
    {
      const std::size_t first = cells.firstCorner[f];
      const std::size_t size = cells.firstCorner[f + 1] - first;
      for (std::size_t i = 0; i < size; ++i)
      {
        const std::uint32_t a = cells.corners[first + i];
        const std::uint32_t b = cells.corners[first + (i + 1) % size];
        edges[{ std::min(a, b), std::max(a, b) }] += a < b ? 1 : -1;
      }
    }
    for (const auto& [ends, sum] : edges)
    {
      EXPECT_EQ(sum, 0) << cell;
    }
  }
}

void expectPairs(const PeriodicFaces& mesh, const SideMotion& motion, double area)
{
  double sum = 0;
  const CellFaces& cells = mesh.cells;
  for (const auto& [a, b] : mesh.pairs)
  {
    const std::size_t size = cells.firstCorner[a + 1] - cells.firstCorner[a];
    ASSERT_EQ(cells.firstCorner[b + 1] - cells.firstCorner[b], size);
    Vector doubled{};
    const Vector origin = pointAt(mesh.points, cells.corners[cells.firstCorner[a]]);
    for (std::size_t i = 0; i < size; ++i)
    {
      const Vector own = pointAt(mesh.points, cells.corners[cells.firstCorner[a] + i]);
      const Vector next =
        pointAt(mesh.points, cells.corners[cells.firstCorner[a] + (i + 1) % size]);
      const Vector other =
        pointAt(mesh.points, cells.corners[cells.firstCorner[b] + (size - i) % size]);
      EXPECT_LT(norm(minus(motion.of(own), other)), 1e-12);
      doubled = plus(doubled, cross(minus(own, origin), minus(next, origin)));
    }
    EXPECT_GT(norm(doubled), 0);
    sum += norm(doubled) / 2;
  }
  EXPECT_NEAR(sum, area, 1e-12 * double(mesh.pairs.size()));
}

}

TEST(PeriodicFaces, OfAnyDivisionsOfASquare)
{
  for (unsigned seed = 0; seed < 2000; ++seed)
  {
    SCOPED_TRACE(seed);
    std::mt19937 random(seed);
    const auto atMost = [&](unsigned most) { return 1 + random() % most; };
    const std::array sizes{ atMost(9), atMost(9), atMost(9), atMost(9) };
    const PlanePolygons a = divided(sizes[0], sizes[1], 0.2, seed);
    const PlanePolygons b = divided(sizes[2], sizes[3], 0.2, seed + 1000);
    const Slabs slabs = slabsOf(a, b);
    const PeriodicFaces mesh = matched(slabs);
    expectClosed(mesh.cells);
    expectPairs(mesh, upwards(), 1);
    EXPECT_NEAR(volumeOf(mesh.cells, mesh.points), 2, 1e-9);
  }
}

TEST(PeriodicFaces, SmallDifferencesMakeNoFaces)
{
  for (unsigned seed = 0; seed < 50; ++seed)
  {
    SCOPED_TRACE(seed);
    const PlanePolygons a = divided(7, 5, 0.1, seed);
    PlanePolygons b = a;
    std::mt19937 random(seed);
    std::uniform_real_distribution<double> aside(-1e-2, 1e-2);
    for (PlanePlace& p : b.points)
    {
      for (double& coordinate : p)
      {
        coordinate += coordinate > 0 && coordinate < 1 ? aside(random) : 0;
      }
    }
    const PeriodicFaces mesh = matched(slabsOf(a, b));
    EXPECT_EQ(mesh.pairs.size(), a.count());
    EXPECT_GT(mesh.farthest, 0);
    EXPECT_LT(mesh.farthest, 0.02);
    expectClosed(mesh.cells);
    expectPairs(mesh, upwards(), 1);
  }
}

TEST(PeriodicFaces, EqualSidesStayAsTheyAre)
{
  const Slabs slabs = slabsOf(divided(4, 6, 0.2, 1), divided(4, 6, 0.2, 1));
  const PeriodicFaces mesh = matched(slabs);
  EXPECT_EQ(mesh.points, slabs.points);
  EXPECT_EQ(mesh.pairs.size(), slabs.sides[0].size());
  EXPECT_EQ(mesh.cells.faceCount(), slabs.cells.faceCount());
  EXPECT_EQ(mesh.farthest, 0);
}

TEST(PeriodicFaces, OneLargeFaceBesideManySmallOnes)
{
  const PeriodicFaces mesh = matched(slabsOf(divided(1, 1, 0, 4), divided(8, 8, 0, 2)));
  EXPECT_GE(mesh.pairs.size(), 64u);
  expectClosed(mesh.cells);
  expectPairs(mesh, upwards(), 1);
}

TEST(PeriodicFaces, TurnedAroundAnAxisThatBothHave)
{
  // The square's sides of two slabs, bent so that they enclose a quarter turn around the y axis.
  SideMotion motion;
  motion.axis = { 0, 1, 0 };
  motion.angle = -90;
  Slabs slabs = slabsOf(divided(3, 4, 0.2, 5), divided(5, 2, 0.2, 6));
  for (std::size_t p = 0; p < slabs.points.size() / 3; ++p)
  {
    double* const at = &slabs.points[3 * p];
    const double x = at[0];
    const double angle = radians(at[2] * 30);
    at[0] = (1 + x) * std::cos(angle);
    at[2] = (1 + x) * std::sin(angle);
  }
  const PeriodicFaces mesh = matched(slabs, motion);
  expectClosed(mesh.cells);
  expectPairs(mesh, motion, 1);
}

TEST(PeriodicFaces, DifferentSidesAreTold)
{
  PlanePolygons narrow = divided(3, 3, 0, 1);
  for (PlanePlace& p : narrow.points)
  {
    p[0] *= 0.5;
  }
  try
  {
    matched(slabsOf(divided(3, 3, 0, 1), narrow));
    FAIL();
  }
  catch (const Error& error)
  {
    EXPECT_EQ(error.fault, Fault::BadMesh);
    EXPECT_NE(std::string(error.what()).find("differ by an area"), std::string::npos)
      << error.what();
  }
  Slabs bent = slabsOf(divided(3, 3, 0, 1), divided(3, 3, 0, 1));
  bent.points[2] = 0.1;
  EXPECT_THROW(matched(bent), Error);
}

TEST(PeriodicFaces, FacesThatCrossThemselvesAreUnfolded)
{
  PlanePolygons folded = divided(4, 4, 0, 1);
  folded.points[6] = { 0.27, 0.52 }; // beyond that above
  const Slabs slabs = slabsOf(folded, divided(3, 5, 0.2, 2));
  const PeriodicFaces mesh = matched(slabs);
  expectClosed(mesh.cells);
  expectPairs(mesh, upwards(), 1);
}

// What a thin plate leaves of a square: its two sides are nearer to each other than points along them.
TEST(PeriodicFaces, BothSidesOfAThinGap)
{
  const auto slit = [](std::size_t n, double half) {
    PlanePolygons all;
    // Rows below and above the gap, which ends in a point on either side.
    for (const double y : { -1.0, -half, half, 1.0 })
    {
      for (std::size_t i = 0; i <= n; ++i)
      {
        const bool isEnd = i == 0 || i == n;
        all.points.push_back({ double(i) / double(n), isEnd && std::abs(y) < 1 ? 0 : y });
      }
    }
    const auto at = [&](std::size_t row, std::size_t i) {
      // The ends of the gap are one point each.
      return static_cast<std::uint32_t>((row == 2 && (i == 0 || i == n) ? 1 : row) * (n + 1) + i);
    };
    for (const std::size_t row : { std::size_t(0), std::size_t(2) })
    {
      for (std::size_t i = 0; i < n; ++i)
      {
        for (const std::uint32_t corner :
          { at(row, i), at(row, i + 1), at(row + 1, i + 1), at(row + 1, i) })
        {
          all.corners.push_back(corner);
        }
        all.firstCorner.push_back(all.corners.size());
      }
    }
    return all;
  };
  for (const double half : { 1e-6, 1e-3, 1e-2 })
  {
    SCOPED_TRACE(half);
    const PlanePolygons a = slit(8, half);
    const Slabs slabs = slabsOf(a, a);
    const PeriodicFaces equal = matched(slabs);
    EXPECT_EQ(equal.points, slabs.points);
    // The same gap, which stands aside by more than it is wide, and whose points lie elsewhere along it.
    PlanePolygons b = a;
    for (PlanePlace& p : b.points)
    {
      const bool isAtEnd = p[0] < 0.2 || p[0] > 0.8;
      if (!isAtEnd && std::abs(p[1]) < 1)
      {
        p[0] += 0.03 * (p[1] > 0 ? 1 : -1);
        p[1] += std::min(3 * half, 0.01);
      }
    }
    const PeriodicFaces mesh = matched(slabsOf(a, b));
    expectClosed(mesh.cells);
    EXPECT_LT(mesh.farthest, 0.04);
  }
}

TEST(PeriodicFaces, OfTheirOwnStayButForTheOutline)
{
  // Rings between the same circles, of other chords.
  const auto ring = [](std::size_t n) {
    PlanePolygons all;
    for (const double radius : { 1.0, 2.0 })
    {
      for (std::size_t i = 0; i < n; ++i)
      {
        const double angle = 2 * Pi * double(i) / double(n);
        all.points.push_back({ radius * std::cos(angle), radius * std::sin(angle) });
      }
    }
    for (std::size_t i = 0; i < n; ++i)
    {
      const std::size_t next = (i + 1) % n;
      for (const std::size_t corner : { i, n + i, n + next, next })
      {
        all.corners.push_back(static_cast<std::uint32_t>(corner));
      }
      all.firstCorner.push_back(all.corners.size());
    }
    return all;
  };
  const Slabs slabs = slabsOf(ring(24), ring(31));
  const double area = 12 * std::sin(Pi / 12) * 3;
  const PeriodicFaces own =
    matchSides(slabs.cells, slabs.points, slabs.sides, upwards(), FacesOfPair::Own);
  expectClosed(own.cells);
  EXPECT_TRUE(own.pairs.empty());
  EXPECT_EQ(own.cells.faceCount(), slabs.cells.faceCount());
  double second = 0;
  for (std::size_t f = 0; f < own.source.size(); ++f)
  {
    const auto& side = slabs.sides[1];
    second += std::find(side.begin(), side.end(), own.source[f]) != side.end()
      ? norm(doubledArea(own.cells, f, own.points)) / 2
      : 0;
  }
  EXPECT_NEAR(second, area, 1e-9);
  const PeriodicFaces same = matched(slabs);
  expectClosed(same.cells);
  expectPairs(same, upwards(), area);
}
