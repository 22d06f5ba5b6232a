// Triangles that cross or overlap, against an independent computation and against all pairs.
#include "Repair/TrianglePairs.h"

#include "Support/Pipeline.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

using namespace cartesian;

namespace
{

// On a lattice so small that double precision tells rational numbers apart.
constexpr int Width = 6;
constexpr double LeastLength = 1e-6;

Surface randomTriangles(unsigned seed, int count, int width)
{
  std::mt19937 random(seed);
  Soup soup;
  for (int i = 0; i < 3 * count; ++i)
  {
    Vector p{};
    for (double& x : p)
    {
      x = 2 * static_cast<double>(random() % static_cast<unsigned>(width)) + 1;
    }
    soup.points.push_back(p);
  }
  for (std::uint32_t t = 0; t < static_cast<std::uint32_t>(count); ++t)
  {
    soup.triangles.push_back({ 3 * t, 3 * t + 1, 3 * t + 2 });
  }
  Execution execution;
  return onLattice(soup.view(), Lattice({ 0, 0, 0 }, 1), execution);
}

Vector normalOfTriangle(const Corners& t)
{
  return cross(minus(t[1], t[0]), minus(t[2], t[0]));
}

// Clips a polygon to the side of a plane through p that its normal points to.
std::vector<Vector> clipped(const std::vector<Vector>& polygon, const Vector& p, const Vector& n)
{
  std::vector<Vector> rest;
  const auto height = [&](const Vector& x) {
    return n[0] * (x[0] - p[0]) + n[1] * (x[1] - p[1]) + n[2] * (x[2] - p[2]);
  };
  for (std::size_t i = 0; i < polygon.size(); ++i)
  {
    const Vector& a = polygon[i];
    const Vector& b = polygon[(i + 1) % polygon.size()];
    const double ha = height(a);
    const double hb = height(b);
    if (ha >= -1e-9)
    {
      rest.push_back(a);
    }
    if ((ha > 1e-9 && hb < -1e-9) || (ha < -1e-9 && hb > 1e-9))
    {
      Vector x{};
      for (std::size_t axis = 0; axis < 3; ++axis)
      {
        x[axis] = a[axis] + ha / (ha - hb) * (b[axis] - a[axis]);
      }
      rest.push_back(x);
    }
  }
  return rest;
}

double extent(const std::vector<Vector>& polygon)
{
  double most = 0;
  for (const Vector& a : polygon)
  {
    for (const Vector& b : polygon)
    {
      most = std::max(most, std::abs(a[0] - b[0]) + std::abs(a[1] - b[1]) + std::abs(a[2] - b[2]));
    }
  }
  return most;
}

double areaOf(const std::vector<Vector>& polygon)
{
  Vector sum{};
  for (std::size_t i = 0; i < polygon.size(); ++i)
  {
    const Vector c = cross(polygon[i], polygon[(i + 1) % polygon.size()]);
    for (std::size_t axis = 0; axis < 3; ++axis)
    {
      sum[axis] += c[axis];
    }
  }
  return std::sqrt(dot(sum, sum)) / 2;
}

// `a` clipped to the prism over `b`, and to its plane from both sides.
Contact wanted(const Surface& surface, std::uint32_t a, std::uint32_t b)
{
  const Corners ca = surface.corners(a);
  const Corners cb = surface.corners(b);
  const Vector n = normalOfTriangle(cb);
  std::vector<Vector> rest{ toVector(ca[0]), toVector(ca[1]), toVector(ca[2]) };
  for (std::size_t i = 0; i < 3; ++i)
  {
    rest = clipped(rest, toVector(cb[i]), cross(n, minus(cb[(i + 1) % 3], cb[i])));
  }
  rest = clipped(rest, toVector(cb[0]), n);
  rest = clipped(rest, toVector(cb[0]), { -n[0], -n[1], -n[2] });
  const Vector m = normalOfTriangle(ca);
  const Vector both = cross(m, n);
  if (dot(both, both) == 0)
  {
    return areaOf(rest) > LeastLength ? Contact::Overlap : Contact::Apart;
  }
  int common = 0;
  for (const Point& p : ca)
  {
    common += static_cast<int>(std::count(cb.begin(), cb.end(), p));
  }
  return common < 2 && extent(rest) > LeastLength ? Contact::Crossing : Contact::Apart;
}

// Two fans of slivers.
Soup bipyramid(std::uint32_t meridians)
{
  Soup soup;
  soup.points = { { 0, 0, 1 }, { 0, 0, -1 } };
  for (std::uint32_t i = 0; i < meridians; ++i)
  {
    const double angle = 2 * std::acos(-1) * i / meridians;
    soup.points.push_back({ std::cos(angle), std::sin(angle), 0 });
    const std::uint32_t next = (i + 1) % meridians;
    soup.triangles.push_back({ 0, 2 + i, 2 + next });
    soup.triangles.push_back({ 1, 2 + next, 2 + i });
  }
  return soup;
}

bool hasArea(const Surface& surface, std::uint32_t t)
{
  const Vector n = normalOfTriangle(surface.corners(t));
  return dot(n, n) > 0;
}

}

TEST(TrianglePairs, ContactsAreThoseOfClipping)
{
  std::map<Contact, int> seen;
  for (unsigned seed = 0; seed < 60; ++seed)
  {
    const int width = 2 + static_cast<int>(seed % (Width - 1));
    const Surface surface = randomTriangles(seed, 40, width);
    for (std::uint32_t a = 0; a < surface.triangles.size(); ++a)
    {
      for (std::uint32_t b = 0; b < surface.triangles.size(); ++b)
      {
        if (a != b && hasArea(surface, a) && hasArea(surface, b))
        {
          const Contact contact = contactOf(surface, a, b);
          ASSERT_EQ(contact, wanted(surface, a, b)) << "seed " << seed << ": " << a << ", " << b;
          ++seen[contact];
        }
      }
    }
  }
  EXPECT_GT(seen[Contact::Overlap], 300);
  EXPECT_GT(seen[Contact::Crossing], 1000);
}

TEST(TrianglePairs, AllAreFound)
{
  for (unsigned seed = 0; seed < 20; ++seed)
  {
    const Surface surface = randomTriangles(seed, 200, 2 + static_cast<int>(seed));
    Execution execution(static_cast<int>(1 + seed % 3));
    const TrianglePairs found = findPairs(surface, execution);
    EXPECT_TRUE(found.givenUp.empty());
    std::size_t next = 0;
    for (std::uint32_t a = 0; a < surface.triangles.size(); ++a)
    {
      for (std::uint32_t b = a + 1; b < surface.triangles.size(); ++b)
      {
        const bool areas = hasArea(surface, a) && hasArea(surface, b);
        const Contact contact = areas ? contactOf(surface, a, b) : Contact::Apart;
        if (contact != Contact::Apart)
        {
          ASSERT_LT(next, found.pairs.size());
          EXPECT_EQ(found.pairs[next].first, a);
          EXPECT_EQ(found.pairs[next].second, b);
          EXPECT_EQ(found.pairs[next].contact, contact);
          ++next;
        }
      }
    }
    EXPECT_EQ(next, found.pairs.size());
  }
}

// Of pairs that do not have the same corners, in whichever order they come.
TEST(TrianglePairs, SearchesEndWhereThereAreEnough)
{
  Surface surface = randomTriangles(1, 400, 8);
  surface.triangles.insert(
    surface.triangles.end(), surface.triangles.begin(), surface.triangles.begin() + 100);
  surface.boundary.resize(surface.triangles.size());
  NearlyFlat nearly{ std::vector<std::uint32_t>(surface.triangles.size()), 0, {} };
  const auto differing = [&](std::size_t enough, int threads) {
    nearly.enough = enough;
    Execution execution(threads);
    const std::vector<TrianglePair> pairs = findPairs(surface, nearly, execution).pairs;
    return static_cast<std::size_t>(std::count_if(pairs.begin(), pairs.end(),
      [&](const TrianglePair& pair) { return !haveSameCorners(surface, pair); }));
  };
  const std::size_t all = differing(std::numeric_limits<std::size_t>::max(), 1);
  ASSERT_GT(all, 1000u);
  for (const bool fewAreNew : { false, true })
  {
    const std::size_t found = fewAreNew ? differing(all + 1, 1) : all;
    ASSERT_GT(found, 40u);
    for (const int threads : { 1, 3 })
    {
      EXPECT_GE(differing(20, threads), 20u);
      EXPECT_LT(differing(20, threads), found);
      EXPECT_EQ(differing(found, threads), found);
      EXPECT_EQ(differing(found + 1, threads), found);
    }
    nearly.isNew.assign(surface.triangles.size(), 0); // then: of one in forty
    for (std::size_t t = 0; t < surface.triangles.size(); t += 40)
    {
      nearly.isNew[t] = 1;
    }
  }
}

// Far from the origin of the lattice, where determinants take a hundred bits.
TEST(TrianglePairs, OneLevelDecides)
{
  Soup soup;
  const double far = 4e9 + 1;
  soup.points = { { 1, 1, 1 }, { far, 1, 1 }, { 1, far, far }, // a slanted triangle
    { 1e9 + 1, 1e9 + 1, 1 }, { 1e9 + 3, 1e9 + 1, 1 }, { 1e9 + 1, 1e9 + 1, 1e9 + 1 } };
  soup.triangles = { { 0, 1, 2 }, { 3, 4, 5 } };
  Execution execution;
  const auto contact = [&](double height) {
    soup.points[5][2] = height;
    return contactOf(onLattice(soup.view(), Lattice({ 0, 0, 0 }, 1), execution), 0, 1);
  };
  EXPECT_EQ(contact(1e9 - 1), Contact::Apart);
  EXPECT_EQ(contact(1e9 + 1), Contact::Apart); // its tip touches
  EXPECT_EQ(contact(1e9 + 3), Contact::Crossing);
}

TEST(TrianglePairs, TheStretchIsWhereTheyCross)
{
  Soup soup;
  soup.points = { { 1, 1, 101 }, { 201, 1, 101 }, { 1, 201, 101 }, { 51, 51, 1 }, { 51, 51, 201 },
    { 51, 301, 101 } };
  soup.triangles = { { 0, 1, 2 }, { 3, 4, 5 } };
  Execution execution;
  const Surface surface = onLattice(soup.view(), Lattice({ 0, 0, 0 }, 1), execution);
  auto ends = sharedSegment(surface.corners(0), surface.corners(1));
  std::sort(ends.begin(), ends.end());
  const std::array<Vector, 2> wantedEnds = { { { 51, 51, 101 }, { 51, 151, 101 } } };
  for (std::size_t i = 0; i < 2; ++i)
  {
    for (std::size_t axis = 0; axis < 3; ++axis)
    {
      EXPECT_NEAR(ends[i][axis], wantedEnds[i][axis], 1e-9);
    }
  }
}

// All triangles around a pole of a sphere are neighbours, hundreds of them.
TEST(TrianglePairs, PolesOfSpheresAreCompared)
{
  constexpr std::uint32_t Meridians = 600;
  Soup soup = bipyramid(Meridians);
  Execution execution(2);
  const auto search = [&] {
    return findPairs(onLattice(soup.view(), Lattice({ -2, -2, -2 }, 1e-9), execution), execution);
  };
  TrianglePairs found = search();
  EXPECT_TRUE(found.givenUp.empty());
  EXPECT_TRUE(found.pairs.empty());
  // A needle from the pole through one of them.
  const auto n = static_cast<std::uint32_t>(soup.points.size());
  soup.points.insert(soup.points.end(), { { 0.3, 0.1, 2 }, { 0.3, 0.1, -2 }, { 0.31, 0.1, 2 } });
  soup.triangles.push_back({ n, n + 1, n + 2 });
  found = search();
  EXPECT_TRUE(found.givenUp.empty());
  EXPECT_FALSE(found.pairs.empty());
  const auto same = [](const TrianglePair& a, const TrianglePair& b) { return !(a < b); };
  EXPECT_EQ(std::adjacent_find(found.pairs.begin(), found.pairs.end(), same), found.pairs.end());
}

// As many neighbours as there are triangles: not all are compared, and the time is bounded.
TEST(TrianglePairs, FansOfSliversAreGivenUp)
{
  constexpr std::uint32_t Slivers = 20000;
  Execution execution(2);
  const TrianglePairs found = findPairs(
    onLattice(bipyramid(Slivers).view(), Lattice({ -2, -2, -2 }, 1e-9), execution), execution);
  EXPECT_GT(found.givenUp.size(), Slivers / 2);
}
