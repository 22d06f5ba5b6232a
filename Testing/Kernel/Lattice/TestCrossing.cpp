// Crossings of edges and triangles with planes and lines, against exact rational numbers, with ties
// broken as in Perturbed.h.
#include "Lattice/Crossing.h"
#include "Support/Effort.h"
#include "Support/Perturbed.h"

#include <boost/multiprecision/cpp_int.hpp>
#include <gtest/gtest.h>

#include <algorithm>
#include <numeric>
#include <random>
#include <tuple>

using namespace cartesian;

namespace
{

using Integer = boost::multiprecision::cpp_int;
using Rational = boost::multiprecision::cpp_rational;
using Exact = Perturbed<Rational>;

// Levels are random within [first, first + width].
struct Range
{
  Level first;
  Level width;
};

constexpr Level HighestLevel = 4200000000U;

// Narrow ranges are full of ties; the widest ones span the whole lattice.
const std::vector<Range> Ranges = { { 0, 10 }, { 0, 40 }, { HighestLevel - 10, 10 }, { 0, 1000 },
  { 0, HighestLevel }, { HighestLevel - 100000, 100000 }, { 0, 1U << 20 } };

class Random
{
public:
  explicit Random(const Range& range)
    : level_(range.first, range.first + range.width)
  {
  }

  Level any() { return level_(engine_); }
  Level odd() { return any() | 1; }
  Level even() { return any() & ~1U; }
  Point vertex() { return { odd(), odd(), odd() }; }
  int axis() { return static_cast<int>(engine_() % 3); }
  std::int64_t to(std::int64_t most)
  {
    return std::uniform_int_distribution<std::int64_t>(0, most)(engine_);
  }

private:
  std::mt19937 engine_{ 1 };
  std::uniform_int_distribution<Level> level_;
};

// The odd level between the even ones that enclose x, once the planes across `axis` are shifted.
Level oddLevel(const Exact& x, int axis)
{
  const Integer whole = numerator(x.c[0]) / denominator(x.c[0]); // of a positive number: floor
  const auto floor = static_cast<Level>(whole);
  if (floor % 2 == 1)
  {
    return floor;
  }
  return x < Exact::plane(axis, floor) ? floor - 1 : floor + 1;
}

Point exactCrossPlane(const Point& a, const Point& b, int axis, Level plane)
{
  const Exact part = Exact::plane(axis, plane) - Exact(Rational(a[axis]));
  const Rational run = Rational(b[axis]) - a[axis];
  Point p{};
  p[axis] = plane;
  for (const int free : { (axis + 1) % 3, (axis + 2) % 3 })
  {
    const Rational slope = (Rational(b[free]) - a[free]) / run;
    p[free] = oddLevel(Exact(Rational(a[free])) + part * slope, free);
  }
  return p;
}

std::array<Integer, 3> normalOf(const Corners& t)
{
  std::array<Integer, 3> n;
  for (int axis = 0; axis < 3; ++axis)
  {
    const int b = (axis + 1) % 3;
    const int c = (axis + 2) % 3;
    const auto difference = [&](int corner, int along) {
      return Integer(t[corner][along]) - t[0][along];
    };
    n[axis] = difference(1, b) * difference(2, c) - difference(1, c) * difference(2, b);
  }
  return n;
}

// Whether the shifted line along `along` passes through the triangle.
bool passes(const Corners& t, int along, const Point& at)
{
  const int b = (along + 1) % 3;
  const int c = (along + 2) % 3;
  int sum = 0;
  for (int i = 0; i < 3; ++i)
  {
    const Point& p = t[i];
    const Point& q = t[(i + 1) % 3];
    const Exact x = Exact::plane(b, at[b]) - Exact(Rational(p[b]));
    const Exact y = Exact::plane(c, at[c]) - Exact(Rational(p[c]));
    sum += (y * (Rational(q[b]) - p[b]) - x * (Rational(q[c]) - p[c])).sign();
  }
  return std::abs(sum) == 3;
}

Level exactCrossLine(const Corners& t, int along, const Point& at)
{
  const std::array<Integer, 3> n = normalOf(t);
  Exact x{ Rational(t[0][along]) };
  for (const int axis : { (along + 1) % 3, (along + 2) % 3 })
  {
    // Of two rationals: dividing 0 by an integer, newer Boosts make 0/16, which they take for positive.
    const Rational slope = Rational(n[axis]) / Rational(n[along]);
    x = x - (Exact::plane(axis, at[axis]) - Exact(Rational(t[0][axis]))) * slope;
  }
  return oddLevel(x, along);
}

void expectCrossPlane(const Point& a, const Point& b, int axis, Level plane)
{
  const Point expected = exactCrossPlane(a, b, axis, plane);
  ASSERT_EQ(crossPlane(a, b, axis, plane), expected)
    << ::testing::PrintToString(a) << " to " << ::testing::PrintToString(b) << ", axis " << axis
    << " at " << plane;
  ASSERT_EQ(crossPlane(b, a, axis, plane), expected);
}

void expectCrossLine(Corners t, int along, const Point& at)
{
  const Level expected = exactCrossLine(t, along, at);
  std::sort(t.begin(), t.end());
  do
  {
    const Point p = crossLine(t, along, at);
    ASSERT_EQ(p[along], expected) << ::testing::PrintToString(t) << ", axis " << along << " at "
                                  << ::testing::PrintToString(at);
    ASSERT_EQ(p[(along + 1) % 3], at[(along + 1) % 3]);
    ASSERT_EQ(p[(along + 2) % 3], at[(along + 2) % 3]);
  } while (std::next_permutation(t.begin(), t.end()));
}

bool separates(const Point& a, const Point& b, int axis, Level plane)
{
  return (a[axis] < plane) != (b[axis] < plane);
}

// x with a * x = 1 modulo m, which have no common divisor.
std::int64_t inverse(std::int64_t a, std::int64_t m)
{
  std::int64_t r0 = m;
  std::int64_t r1 = a % m;
  std::int64_t x0 = 0;
  std::int64_t x1 = 1;
  while (r1 != 0)
  {
    const std::int64_t q = r0 / r1;
    std::tie(r0, r1) = std::make_pair(r1, r0 - q * r1);
    std::tie(x0, x1) = std::make_pair(x1, x0 - q * x1);
  }
  return (x0 % m + m) % m;
}

}

TEST(CrossPlane, IsExact)
{
  for (const Range& range : Ranges)
  {
    Random random(range);
    for (unsigned i = 0; i < repeats(2000); ++i)
    {
      const Point a = random.vertex();
      const Point b = random.vertex();
      const int axis = random.axis();
      const Level plane = random.even();
      if (separates(a, b, axis, plane))
      {
        expectCrossPlane(a, b, axis, plane);
      }
    }
  }
}

// A crossing of a long edge misses an even level by as little as possible: 2 / run.
TEST(CrossPlane, IsExactWhereItAlmostTies)
{
  Random random({ 0, HighestLevel });
  int found = 0;
  for (int i = 0; i < 20000 && found < 3000; ++i)
  {
    const std::int64_t run = 2 * (1 + random.to(HighestLevel / 2 - 2));
    const std::int64_t part = 1 + 2 * random.to(run / 2 - 1); // 0 < part < run
    if (std::gcd(part, run / 2) != 1 || run < 4)
    {
      continue;
    }
    // rise * part = whole * run + 2 or - 2.
    std::int64_t rise = 2 * inverse(part, run / 2);
    rise = i % 2 ? run - rise : rise;
    const std::int64_t first = 1;
    if (rise + first > HighestLevel)
    {
      continue;
    }
    const int axis = random.axis();
    Point a = { 1, 1, 1 };
    Point b = random.vertex();
    b[axis] = static_cast<Level>(1 + run);
    b[(axis + 1) % 3] = static_cast<Level>(first + rise);
    b[(axis + 2) % 3] = static_cast<Level>(first + run - rise % run);
    expectCrossPlane(a, b, axis, static_cast<Level>(1 + part));
    ++found;
  }
  EXPECT_GT(found, 1000);
}

// All edges and planes of a lattice of six levels.
TEST(CrossPlane, IsExactOnAllOfATinyLattice)
{
  const auto points = [](int i) {
    return Point{ 1 + 2 * static_cast<Level>(i % 4), 1 + 2 * static_cast<Level>(i / 4 % 4),
      1 + 2 * static_cast<Level>(i / 16) };
  };
  for (int i = 0; i < 64; ++i)
  {
    for (int j = 0; j < i; ++j)
    {
      for (int axis = 0; axis < 3; ++axis)
      {
        for (Level plane = 2; plane <= 6; plane += 2)
        {
          if (separates(points(i), points(j), axis, plane))
          {
            expectCrossPlane(points(i), points(j), axis, plane);
          }
        }
      }
    }
  }
}

// "Right of the plane in x where it crosses y" and "above the plane in y where it crosses x" are the
// same question: boxes on either side must agree.
TEST(CrossPlane, AnswersAgreeBetweenTwoPlanes)
{
  for (const Range& range : Ranges)
  {
    Random random(range);
    for (unsigned i = 0; i < repeats(3000); ++i)
    {
      const Point a = random.vertex();
      const Point b = random.vertex();
      const int u = random.axis();
      const int v = (u + 1 + static_cast<int>(random.to(1))) % 3;
      const Level pu = random.even();
      const Level pv = random.even();
      if (separates(a, b, u, pu) && separates(a, b, v, pv))
      {
        const bool falling = (a[u] < b[u]) != (a[v] < b[v]);
        const bool right = crossPlane(a, b, v, pv)[u] > pu;
        const bool above = crossPlane(a, b, u, pu)[v] > pv;
        ASSERT_EQ(right != above, !falling);
      }
    }
  }
}

TEST(CrossPlane, IsMonotonous)
{
  for (const Range& range : Ranges)
  {
    Random random(range);
    for (unsigned i = 0; i < repeats(500); ++i)
    {
      Point a = random.vertex();
      Point b = random.vertex();
      const int axis = random.axis();
      if (a[axis] > b[axis])
      {
        std::swap(a, b);
      }
      std::vector<Level> planes(20);
      std::generate(planes.begin(), planes.end(), [&] { return random.even(); });
      std::sort(planes.begin(), planes.end());
      Point before = a;
      for (const Level plane : planes)
      {
        if (separates(a, b, axis, plane))
        {
          const Point p = crossPlane(a, b, axis, plane);
          for (const int free : { (axis + 1) % 3, (axis + 2) % 3 })
          {
            const auto [low, high] = std::minmax(before[free], b[free]);
            ASSERT_LE(low, p[free]);
            ASSERT_LE(p[free], high);
          }
          before = p;
        }
      }
    }
  }
}

TEST(CrossLine, IsExact)
{
  int found = 0;
  for (const Range& range : Ranges)
  {
    Random random(range);
    for (unsigned i = 0; i < repeats(3000); ++i)
    {
      const Corners t = { random.vertex(), random.vertex(), random.vertex() };
      const int along = random.axis();
      const Point at = { random.even(), random.even(), random.even() };
      if (passes(t, along, at))
      {
        expectCrossLine(t, along, at);
        ++found;
      }
    }
  }
  EXPECT_GT(found, int(repeats(1000)));
}

// Triangles that are slivers when seen along the line, and steep: the crossing is a small difference
// of large products divided by a small number.
TEST(CrossLine, IsExactOnSlivers)
{
  Random random({ 0, HighestLevel });
  int found = 0;
  for (unsigned i = 0; i < repeats(20000); ++i)
  {
    const int along = random.axis();
    const Point at = { HighestLevel / 2 & ~1U, HighestLevel / 2 & ~1U, HighestLevel / 2 & ~1U };
    const std::array<std::int64_t, 2> direction = { random.to(999) - 500, random.to(999) - 500 };
    Corners t;
    for (int corner = 0; corner < 3; ++corner)
    {
      const std::int64_t way = (corner - 1) * random.to(1000000);
      t[corner][along] = random.odd();
      for (int k = 0; k < 2; ++k)
      {
        const int axis = (along + 1 + k) % 3;
        t[corner][axis] =
          static_cast<Level>(at[axis] + 2 * way * direction[k] + 2 * random.to(4) - 3);
      }
    }
    if (passes(t, along, at))
    {
      expectCrossLine(t, along, at);
      ++found;
    }
  }
  EXPECT_GT(found, int(repeats(1000)));
}

// Far vertices, and the crossing exactly on an even level: planes of symmetry.
TEST(CrossLine, IsExactWhereLargeTrianglesTie)
{
  const Level middle = HighestLevel / 2 & ~1U;
  Random random({ 0, middle - 2 });
  for (unsigned i = 0; i < repeats(2000); ++i)
  {
    const Point at = { middle, middle, middle };
    const Point p = random.vertex();
    const Point q = { 2 * middle - p[0], 2 * middle - p[1], 2 * middle - p[2] };
    const Corners t = { p, q, random.vertex() };
    for (int along = 0; along < 3; ++along)
    {
      if (passes(t, along, at))
      {
        expectCrossLine(t, along, at);
      }
    }
  }
}

// Where a plane's edge crosses another plane and where the line of both planes crosses a triangle
// with that edge are ordered alike.
TEST(CrossLine, IsMonotonous)
{
  for (const Range& range : Ranges)
  {
    Random random(range);
    for (unsigned i = 0; i < repeats(1000); ++i)
    {
      const Corners t = { random.vertex(), random.vertex(), random.vertex() };
      const int along = random.axis();
      const int b = (along + 1) % 3;
      const std::array<Integer, 3> n = normalOf(t);
      Point at = { random.even(), random.even(), random.even() };
      Level other = random.even();
      if (other < at[b])
      {
        std::swap(other, at[b]);
      }
      Point next = at;
      next[b] = other;
      if (passes(t, along, at) && passes(t, along, next))
      {
        const Level p = crossLine(t, along, at)[along];
        const Level q = crossLine(t, along, next)[along];
        if (n[b] * n[along] >= 0) // falls from p to q, or is level
        {
          ASSERT_GE(p, q);
        }
        if (n[b] * n[along] <= 0)
        {
          ASSERT_LE(p, q);
        }
      }
    }
  }
}
