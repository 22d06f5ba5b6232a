// The parts of triangles between planes.
#include "Lattice/ExactFit.h"
#include "Lattice/Plane.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <random>
#include <set>

using namespace cartesian;

namespace
{

class Random
{
public:
  explicit Random(Level most)
    : level_(0, most)
  {
  }

  Level even() { return level_(engine_) & ~1U; }
  Level odd() { return level_(engine_) | 1; }
  Corners triangle()
  {
    Corners t;
    for (Point& p : t)
    {
      p = { odd(), odd(), odd() };
    }
    return t;
  }

private:
  std::mt19937 engine_{ 1 };
  std::uniform_int_distribution<Level> level_;
};

// Twice the area seen along an axis.
Wide areaAlong(const Fragment& f, int axis)
{
  Wide sum = 0;
  for (int i = 1; i + 1 < f.size; ++i)
  {
    sum +=
      turn(flatten(f.corner[0], axis), flatten(f.corner[i], axis), flatten(f.corner[i + 1], axis));
  }
  return sum;
}

std::set<Point> pointsOf(const Fragment& f)
{
  return { f.corner.begin(), f.corner.begin() + f.size };
}

// Every side lies on the edge or plane that it names.
void expectSides(const Corners& triangle, const Fragment& f)
{
  for (int i = 0; i < f.size; ++i)
  {
    const Point& p = f.corner[i];
    const Point& q = f.corner[(i + 1) % f.size];
    if (f.side[i] >= Fragment::FirstPlane)
    {
      const int axis = f.side[i] - Fragment::FirstPlane;
      EXPECT_TRUE(onPlane(p[axis]));
      EXPECT_EQ(p[axis], q[axis]);
    }
    else
    {
      for (int axis = 0; axis < 3; ++axis)
      {
        const auto [low, high] =
          std::minmax(triangle[f.side[i]][axis], triangle[(f.side[i] + 1) % 3][axis]);
        EXPECT_LE(low, p[axis]);
        EXPECT_LE(p[axis], high);
      }
    }
  }
}

}

TEST(ExactFit, SplitLeavesBothPartsOnTheirSides)
{
  for (const Level most : { 12U, 100U, 4200000000U })
  {
    Random random(most);
    for (int i = 0; i < 2000; ++i)
    {
      const Corners t = random.triangle();
      const int axis = i % 3;
      const Level plane = random.even();
      Fragment below;
      Fragment above;
      split(t, Fragment::whole(t), axis, plane, &below, &above);
      for (int c = 0; c < below.size; ++c)
      {
        EXPECT_LE(below.corner[c][axis], plane);
      }
      for (int c = 0; c < above.size; ++c)
      {
        EXPECT_GE(above.corner[c][axis], plane);
      }
      EXPECT_TRUE(below.size == 0 || below.size == 3 || below.size == 4);
      EXPECT_EQ(below.size + above.size, below.size == 0 || above.size == 0 ? 3 : 7);
      expectSides(t, below);
      expectSides(t, above);
    }
  }
}

// Corners come from the triangle, never from other corners: the order of planes does not matter.
TEST(ExactFit, PiecesDependOnNoOrder)
{
  for (const Level most : { 12U, 100U, 4200000000U })
  {
    Random random(most);
    for (int i = 0; i < 2000; ++i)
    {
      const Corners t = random.triangle();
      const std::array<Level, 3> planes = { random.even(), random.even(), random.even() };
      std::array<int, 3> order = { 0, 1, 2 };
      std::set<std::set<Point>> results;
      do
      {
        Fragment rest = Fragment::whole(t);
        for (const int axis : order)
        {
          Fragment above;
          split(t, rest, axis, planes[axis], nullptr, &above);
          rest = above;
        }
        expectSides(t, rest);
        results.insert(pointsOf(rest));
      } while (std::next_permutation(order.begin(), order.end()));
      ASSERT_EQ(results.size(), 1U);
    }
  }
}

// Both sides of a plane get the same corners on it.
TEST(ExactFit, NeighboursShareTheirEdge)
{
  Random random(1000000);
  for (int i = 0; i < 2000; ++i)
  {
    const Corners t = random.triangle();
    std::array<Level, 3> x = { random.even(), random.even(), random.even() };
    std::sort(x.begin(), x.end());
    const Fragment left = clip(t, { x[0], 0, 0 }, { x[1], 4200000000U, 4200000000U });
    const Fragment right = clip(t, { x[1], 0, 0 }, { x[2], 4200000000U, 4200000000U });
    const auto onMiddle = [&](const Fragment& f) {
      std::set<Point> points = pointsOf(f);
      for (auto p = points.begin(); p != points.end();)
      {
        p = (*p)[0] == x[1] ? std::next(p) : points.erase(p);
      }
      return points;
    };
    if (x[0] < x[1] && x[1] < x[2])
    {
      ASSERT_EQ(onMiddle(left), onMiddle(right));
    }
  }
}

// The projected areas of a triangle's pieces add up, except for rounding.
TEST(ExactFit, PiecesAddUp)
{
  Random random(4200000000U);
  for (int i = 0; i < 200; ++i)
  {
    const Corners t = random.triangle();
    const std::array<Level, 4> planes = { 0, 1000000000, 2500000000, 4200000002U };
    for (int axis = 0; axis < 3; ++axis)
    {
      Wide sum = 0;
      for (int box = 0; box < 27; ++box)
      {
        const std::array<int, 3> at = { box % 3, box / 3 % 3, box / 9 };
        const Point low = { planes[at[0]], planes[at[1]], planes[at[2]] };
        const Point high = { planes[at[0] + 1], planes[at[1] + 1], planes[at[2] + 1] };
        const Fragment piece = clip(t, low, high);
        EXPECT_LE(piece.size, Fragment::MostCorners);
        expectSides(t, piece);
        sum += areaAlong(piece, axis);
      }
      const Wide off = sum - areaAlong(Fragment::whole(t), axis);
      EXPECT_LT(std::abs(static_cast<double>(off)), 1e12); // a hundred levels of 4.2e9 x 2
    }
  }
}
