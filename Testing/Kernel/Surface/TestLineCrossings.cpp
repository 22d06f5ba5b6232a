// Crossings of mesh lines with the surface: for a closed surface, however degenerate, those along
// x, y and z give every vertex of the global mesh the same winding.
#include "Support/Effort.h"
#include "Support/Perturbed.h"
#include "Support/Pipeline.h"
#include "Surface/LineCrossings.h"

#include <gtest/gtest.h>

using namespace cartesian;

namespace
{

std::vector<Level> evenLevels(std::int64_t most, std::int64_t step)
{
  std::vector<Level> levels;
  for (std::int64_t level = 0; level <= most; level += step)
  {
    levels.push_back(static_cast<Level>(level));
  }
  return levels;
}

Meshlines everyEvenLevel(int width)
{
  const std::vector<Level> levels = evenLevels(2 * width + 2, 2);
  return { { levels, levels, levels } };
}

void expectAgreement(const Surface& surface, const Meshlines& planes)
{
  const std::vector<Winding> alongX = windings(surface, planes, 0);
  ASSERT_TRUE(alongX == windings(surface, planes, 1));
  ASSERT_TRUE(alongX == windings(surface, planes, 2));
}

using Number = Perturbed<std::int64_t>;

// Whether the shifted line through the vertex along `along` passes through the triangle below it.
bool crossesBelow(const Corners& t, const Point& vertex, int along)
{
  const int b = (along + 1) % 3;
  const int c = (along + 2) % 3;
  std::array<std::int64_t, 3> n{};
  std::array<int, 3> turns{};
  for (int i = 0; i < 3; ++i)
  {
    const Point& p = t[i];
    const Point& q = t[(i + 1) % 3];
    const auto difference = [&](int axis) { return std::int64_t(q[axis]) - p[axis]; };
    const Number x = Number::plane(b, vertex[b]) - Number(p[b]);
    const Number y = Number::plane(c, vertex[c]) - Number(p[c]);
    turns[i] = (y * difference(b) - x * difference(c)).sign();
    for (int axis = 0; axis < 3; ++axis)
    {
      const int u = (axis + 1) % 3;
      const int v = (axis + 2) % 3;
      n[axis] += std::int64_t(p[u]) * q[v] - std::int64_t(p[v]) * q[u];
    }
  }
  if (turns[0] != turns[1] || turns[1] != turns[2] || turns[0] == 0)
  {
    return false;
  }
  Number height; // of the vertex above the triangle's plane, along the normal
  for (int axis = 0; axis < 3; ++axis)
  {
    height = height + (Number::plane(axis, vertex[axis]) - Number(t[0][axis])) * n[axis];
  }
  return height.sign() * (n[along] > 0 ? 1 : -1) > 0;
}

}

TEST(LineCrossings, OfOneTriangleAreExact)
{
  const int width = 5;
  const Meshlines planes = everyEvenLevel(width);
  for (unsigned seed = 0; seed < repeats(30); ++seed)
  {
    Soup soup = randomTetrahedra(seed, 1, width);
    soup.triangles.resize(1);
    Execution execution;
    const Surface surface = onLattice(soup.view(), Lattice({ 0, 0, 0 }, 1), execution);
    for (int axis = 0; axis < 3; ++axis)
    {
      const std::vector<Winding> found = windings(surface, planes, axis);
      const int up = exactNormal(surface.corners(0))[axis] > 0 ? 1 : -1;
      std::size_t i = 0;
      for (const Level z : planes[2])
      {
        for (const Level y : planes[1])
        {
          for (const Level x : planes[0])
          {
            const bool crosses = crossesBelow(surface.corners(0), { x, y, z }, axis);
            ASSERT_EQ(found[i++].turns, crosses ? -up : 0);
          }
        }
      }
    }
  }
}

TEST(LineCrossings, AgreeOnTinyLattices)
{
  for (unsigned seed = 0; seed < repeats(60); ++seed)
  {
    const int width = 1 + static_cast<int>(seed % 9);
    const Meshlines planes = everyEvenLevel(width);
    const Soup soup = randomTetrahedra(seed, 1 + static_cast<int>(seed % 20), width);
    expectAgreement(prepareOnLevels(soup, planes).surface, planes);
  }
}

TEST(LineCrossings, AgreeOnLargeLattices)
{
  const int width = 2099999999;
  const std::vector<Level> levels = evenLevels(4200000000, 300000000);
  const Meshlines planes = { { levels, levels, levels } };
  for (unsigned seed = 0; seed < repeats(10); ++seed)
  {
    const Soup soup = randomTetrahedra(seed, 20, width);
    expectAgreement(prepareOnLevels(soup, planes).surface, planes);
  }
}

TEST(LineCrossings, AgreeOnShapes)
{
  for (const NamedShape& shape : cleanShapes())
  {
    SCOPED_TRACE(shape.name);
    for (const double cells : { 2.0, 7.9 })
    {
      const PreparedSurface prepared = prepare(shape.soup, cellsAlongLongest(shape.soup, cells));
      expectAgreement(prepared.surface, prepared.planes);
    }
  }
}

// Vertices of the grid are inside where they lie within the cube, and outside elsewhere.
TEST(LineCrossings, TellInsideFromOutside)
{
  GridSpec grid;
  grid.meshlines.fill({ -1, -0.5, 0.25, 0.5, 0.75, 2 });
  const PreparedSurface prepared = prepare(cube(), grid);
  const std::vector<Winding> found = windings(prepared.surface, prepared.planes, 2);
  for (int i = 0; i < 216; ++i)
  {
    const auto within = [](int x) { return x >= 2 && x <= 4; };
    EXPECT_EQ(found[static_cast<std::size_t>(i)].inside(),
      within(i % 6) && within(i / 6 % 6) && within(i / 36))
      << i;
  }
}
