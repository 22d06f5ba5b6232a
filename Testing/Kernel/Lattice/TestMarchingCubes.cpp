// Marching Cubes (section 4.7): the criterion, all patterns, and the choice among configurations.
#include "Lattice/MarchingCubes.h"
#include "Support/MeshChecker.h"

#include <gtest/gtest.h>

#include <functional>
#include <numeric>
#include <random>

using namespace cartesian;

namespace
{

LoopNode node(const Vector& at, const Vector& normal)
{
  return { 0, at, unit(normal), 0 };
}

std::size_t diagonalFrom(const std::vector<LoopTriangulation::Triangle>& triangles)
{
  // Of a quadrilateral: 0 if nodes 0 and 2 are joined, 1 if 1 and 3 are.
  const auto& t = triangles[0];
  const bool has0 = std::find(t.begin(), t.end(), 0u) != t.end();
  const bool has2 = std::find(t.begin(), t.end(), 2u) != t.end();
  return has0 && has2 ? 0 : 1;
}

// A block of the domain around lattice vertices 1 or 2 along each axis: a bit of `pattern` for each.
// Joined: the points less than 0.6 from an inside vertex; else those farther from all outside ones.
Soup blocks(unsigned pattern, bool joined)
{
  std::array<std::vector<double>, 3> lines;
  for (auto& axis : lines)
  {
    for (int i = 0; i <= 3; ++i)
    {
      axis.push_back(i - 0.4);
      axis.push_back(i + 0.4);
    }
    axis.pop_back();
    axis.erase(axis.begin());
    std::sort(axis.begin(), axis.end());
  }
  const auto inside = [&](int i, int j, int k) {
    const std::array<int, 3> zone = { i, j, k };
    const auto near = [&](const std::array<int, 3>& vertex) {
      for (std::size_t axis = 0; axis < 3; ++axis)
      {
        const double middle =
          (lines[axis][std::size_t(zone[axis])] + lines[axis][std::size_t(zone[axis]) + 1]) / 2;
        if (std::abs(middle - vertex[axis]) > 0.6)
        {
          return false;
        }
      }
      return true;
    };
    bool nearInside = false;
    bool nearOutside = false;
    for (int x = 0; x <= 3; ++x)
    {
      for (int y = 0; y <= 3; ++y)
      {
        for (int z = 0; z <= 3; ++z)
        {
          const bool among = x % 3 != 0 && y % 3 != 0 && z % 3 != 0;
          const int bit = (x - 1) + 2 * (y - 1) + 4 * (z - 1);
          const bool in = among && (pattern >> bit & 1) != 0;
          nearInside = nearInside || (in && near({ x, y, z }));
          nearOutside = nearOutside || (!in && near({ x, y, z }));
        }
      }
    }
    return joined ? nearInside : !nearOutside;
  };
  return voxels(lines, inside);
}

// Sets of patches that share edges, in the box between the vertices 1 and 2.
std::size_t sheetsInTheMiddle(const Meshed& meshed)
{
  Execution execution;
  const std::vector<std::uint32_t> intersected = intersectedBoxes(meshed.boxed.boxes, execution);
  const Patches& patches = meshed.patches;
  for (std::size_t n = 0; n < intersected.size(); ++n)
  {
    if (meshed.boxed.boxes.globalOf(meshed.boxed.boxes.packed[intersected[n]]).index !=
      std::array<std::uint32_t, 3>{ 1, 1, 1 })
    {
      continue;
    }
    std::map<std::uint32_t, std::uint32_t> parent;
    const std::function<std::uint32_t(std::uint32_t)> root = [&](std::uint32_t x) {
      return parent[x] == x ? x : root(parent[x]);
    };
    for (std::size_t c = patches.start[patches.boxStart[n]];
         c < patches.start[patches.boxStart[n + 1]]; ++c)
    {
      parent[patches.corners[c]] = patches.corners[c];
    }
    for (std::size_t p = patches.boxStart[n]; p < patches.boxStart[n + 1]; ++p)
    {
      for (std::size_t c = patches.start[p]; c < patches.start[p + 1]; ++c)
      {
        parent[root(patches.corners[c])] = root(patches.corners[patches.start[p]]);
      }
    }
    return static_cast<std::size_t>(std::count_if(
      parent.begin(), parent.end(), [](const auto& entry) { return entry.first == entry.second; }));
  }
  return 0;
}

Meshed meshByMarchingCubes(const Soup& soup)
{
  TestOptions options = asTheyAre();
  options.patches.method = PatchMethod::MarchingCubes;
  GridSpec grid;
  for (auto& lines : grid.meshlines)
  {
    lines = { 0, 1, 2, 3 };
  }
  return meshOf(soup, grid, options);
}

}

TEST(MarchingCubes, CriterionIsEquation4)
{
  EXPECT_NEAR(criterion(1), 1, 1e-12);
  EXPECT_NEAR(criterion(-1), 4, 1e-12);
  EXPECT_NEAR(criterion(0), (3 * 7 + 49 - 4) / 48.0, 1e-12);
  for (double s = -1; s < 1; s += 0.1)
  {
    EXPECT_GT(criterion(s), criterion(s + 0.1));
  }
}

// The sum of the criterion over the nodes of all triangles, divided by three.
TEST(MarchingCubes, NoTriangulationOfALoopHasALowerCriterion)
{
  std::mt19937 random(3);
  const auto number = [&] { return static_cast<double>(random()) / 4294967296.0; };
  for (int trial = 0; trial < 200; ++trial)
  {
    std::vector<LoopNode> loop;
    for (int i = 0; i < 9; ++i)
    {
      const double angle = 2 * Pi * i / 9;
      const double radius = 0.3 + number();
      loop.push_back(node({ radius * std::cos(angle), radius * std::sin(angle), 0.5 * number() },
        { number() - 0.5, number() - 0.5, trial % 2 == 0 ? 1 : 0.2 }));
    }
    const auto cost = [&](std::size_t a, std::size_t b, std::size_t c) {
      const Vector normal =
        unit(cross(minus(loop[b].at, loop[a].at), minus(loop[c].at, loop[a].at)));
      return (criterion(dot(normal, loop[a].normal)) + criterion(dot(normal, loop[b].normal)) +
               criterion(dot(normal, loop[c].normal))) /
        3;
    };
    const std::function<double(std::size_t, std::size_t)> least = [&](
                                                                    std::size_t i, std::size_t j) {
      double best = j < i + 2 ? 0 : 1e9;
      for (std::size_t k = i + 1; k < j; ++k)
      {
        best = std::min(best, least(i, k) + least(k, j) + cost(i, k, j));
      }
      return best;
    };
    LoopTriangulation triangulation;
    double sum = 0;
    for (const auto& t : triangulation.triangulate(loop))
    {
      sum += cost(t[0], t[1], t[2]);
    }
    EXPECT_NEAR(sum, least(0, loop.size() - 1), 1e-9);
  }
}

TEST(MarchingCubes, OfTwoDiagonalsTheSurfaceChooses)
{
  // A roof whose ridge joins two opposite corners, which lie higher than the others.
  const std::array<Vector, 4> at = { Vector{ 0, 0, 1 }, { 1, 0, 0 }, { 1, 1, 1 }, { 0, 1, 0 } };
  LoopTriangulation triangulation;
  const std::vector<LoopNode> ridge = { node(at[0], { 0, 0, 1 }), node(at[1], { 1, -1, 1 }),
    node(at[2], { 0, 0, 1 }), node(at[3], { -1, 1, 1 }) };
  EXPECT_EQ(diagonalFrom(triangulation.triangulate(ridge)), 0u);
  // A valley between the same corners.
  const std::vector<LoopNode> valley = { node(at[0], { 1, 1, 1 }), node(at[1], { 0, 0, 1 }),
    node(at[2], { -1, -1, 1 }), node(at[3], { 0, 0, 1 }) };
  EXPECT_EQ(diagonalFrom(triangulation.triangulate(valley)), 1u);
}

TEST(MarchingCubes, NoTriangleLiesInASideOfTheBox)
{
  // Three nodes on one side, the middle one at a finer neighbour's edge.
  LoopTriangulation triangulation;
  const Vector up{ 0, 0, 1 };
  std::vector<LoopNode> loop = { node({ 0, 0, 0 }, up), node({ 0.5, 0, 0.2 }, up),
    node({ 1, 0, 0 }, up), node({ 1, 1, 0 }, up), node({ 0, 1, 0 }, up) };
  loop[0].planes = loop[1].planes = loop[2].planes = 4;
  for (const auto& t : triangulation.triangulate(loop))
  {
    EXPECT_FALSE(t[0] < 3 && t[1] < 3 && t[2] < 3);
  }
}

TEST(MarchingCubes, LongLoopsAreClosedToo)
{
  LoopTriangulation triangulation;
  for (const std::size_t n : { 3u, 7u, 32u, 33u, 100u, 301u })
  {
    std::vector<LoopNode> loop;
    for (std::size_t i = 0; i < n; ++i)
    {
      const double angle = 2 * Pi * double(i) / double(n);
      loop.push_back(node({ std::cos(angle), std::sin(angle), 0 }, { 0, 0, 1 }));
    }
    std::map<std::pair<std::uint32_t, std::uint32_t>, int> edges;
    const auto& triangles = triangulation.triangulate(loop);
    EXPECT_EQ(triangles.size(), n - 2);
    for (const auto& t : triangles)
    {
      for (std::size_t i = 0; i < 3; ++i)
      {
        ++edges[{ t[i], t[(i + 1) % 3] }];
        --edges[{ t[(i + 1) % 3], t[i] }];
      }
    }
    for (std::uint32_t i = 0; i < n; ++i)
    {
      EXPECT_EQ((edges[{ i, std::uint32_t((i + 1) % n) }]), 1);
      edges[{ i, std::uint32_t((i + 1) % n) }] = edges[{ std::uint32_t((i + 1) % n), i }] = 0;
    }
    for (const auto& [edge, sum] : edges)
    {
      EXPECT_EQ(sum, 0);
    }
  }
}

// The basic patterns by their inside corners, bit x + 2 y + 4 z, and how many separate sheets the
// surface has if inside corners that are diagonal on a side are joined, and if they are not.
TEST(MarchingCubes, AllBasicPatterns)
{
  struct Pattern
  {
    unsigned corners;
    std::size_t joined;
    std::size_t separate;
  };
  const std::vector<Pattern> patterns = {
    { 0b00000001, 1, 1 }, // one corner
    { 0b00000011, 1, 1 }, // an edge
    { 0b00001001, 1, 2 }, // diagonal on a side
    { 0b10000001, 2, 2 }, // diagonal in the box
    { 0b00000111, 1, 1 }, // three on a side
    { 0b10000011, 1, 2 }, // an edge and a corner diagonal to it on a side
    { 0b00010110, 2, 3 }, // three corners, each diagonal to the others
    { 0b00001111, 1, 1 }, // a side
    { 0b00010111, 1, 1 }, // a corner and its three neighbours
    { 0b00100111, 1, 1 }, // a chain in space
    { 0b11000011, 2, 2 }, // two edges diagonal in the box
    { 0b10000111, 2, 2 }, // three on a side and the corner diagonal to all
    { 0b01101001, 4, 4 }, // four corners, each diagonal to the others
    { 0b01000111, 1, 1 }, // a chain in space, the other way
  };
  for (const Pattern& pattern : patterns)
  {
    for (const bool joined : { true, false })
    {
      SCOPED_TRACE(std::to_string(pattern.corners) + (joined ? " joined" : " separate"));
      const Meshed meshed = meshByMarchingCubes(blocks(pattern.corners, joined));
      EXPECT_TRUE(isValid(meshed.mesh));
      EXPECT_EQ(meshed.statistics.at("BoxesByExactFit"), 0);
      EXPECT_EQ(sheetsInTheMiddle(meshed), joined ? pattern.joined : pattern.separate);
    }
  }
}

TEST(MarchingCubes, AllPatternsGiveValidCells)
{
  for (unsigned pattern = 1; pattern < 255; ++pattern)
  {
    for (const bool joined : { true, false })
    {
      SCOPED_TRACE(pattern);
      const Meshed meshed = meshByMarchingCubes(blocks(pattern, joined));
      EXPECT_TRUE(isValid(meshed.mesh));
      EXPECT_TRUE(meshed.flawedBoxes.empty());
    }
  }
}
