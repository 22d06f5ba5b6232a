// Patches are a watertight surface that covers the triangles exactly.
#include "Support/Effort.h"
#include "Support/Pipeline.h"

#include "Boxes/PlaneClearance.h"

#include <gtest/gtest.h>

#include <cmath>
#include <set>

using namespace cartesian;

namespace
{

Patches patchesOf(const PreparedSurface& prepared, const RefinementSpec& refinement)
{
  Execution execution;
  const BoxedSurface boxed = boxSurface(prepared, refinement, execution);
  return generatePatches(prepared.surface, boxed.boxes, boxed.shoeboxes, exactFit(), execution);
}

// How often each edge is run through, less the other way.
std::map<std::pair<std::uint32_t, std::uint32_t>, int> edgesOf(const Patches& patches)
{
  std::map<std::pair<std::uint32_t, std::uint32_t>, int> sums;
  for (std::size_t p = 0; p < patches.size(); ++p)
  {
    std::uint32_t from = patches.corners[patches.start[p + 1] - 1];
    for (std::size_t c = patches.start[p]; c < patches.start[p + 1]; ++c)
    {
      const std::uint32_t to = patches.corners[c];
      sums[std::minmax(from, to)] += from < to ? 1 : -1;
      from = to;
    }
  }
  return sums;
}

void expectWatertight(const Patches& patches)
{
  for (const auto& [edge, sum] : edgesOf(patches))
  {
    ASSERT_EQ(sum, 0) << edge.first << " to " << edge.second;
    ASSERT_NE(edge.first, edge.second);
  }
  const std::set<Point> points(patches.points.begin(), patches.points.end());
  EXPECT_EQ(points.size(), patches.points.size());
  const std::set<std::uint32_t> used(patches.corners.begin(), patches.corners.end());
  EXPECT_EQ(used.size(), patches.points.size());
}

double areaOf(const Patches& patches, std::size_t patch, const Lattice& lattice)
{
  const auto at = [&](std::size_t corner) {
    const Point& p = patches.points[patches.corners[corner]];
    return Vector{ lattice.position(0, p[0]), lattice.position(1, p[1]),
      lattice.position(2, p[2]) };
  };
  Vector sum{};
  const Vector base = at(patches.start[patch]);
  for (std::size_t c = patches.start[patch] + 1; c + 1 < patches.start[patch + 1]; ++c)
  {
    for (int axis = 0; axis < 3; ++axis)
    {
      const int u = (axis + 1) % 3;
      const int v = (axis + 2) % 3;
      sum[axis] += (at(c)[u] - base[u]) * (at(c + 1)[v] - base[v]) -
        (at(c)[v] - base[v]) * (at(c + 1)[u] - base[u]);
    }
  }
  return std::sqrt(sum[0] * sum[0] + sum[1] * sum[1] + sum[2] * sum[2]) / 2;
}

// The patches of every triangle make up its area; those that fall on others on this lattice are gone.
void expectCovered(const Patches& patches, const Surface& surface, const Soup& soup)
{
  const Lattice& lattice = surface.lattice;
  std::vector<double> areas(soup.triangles.size());
  for (std::size_t p = 0; p < patches.size(); ++p)
  {
    const std::uint32_t triangle = surface.given[patches.triangle[p]];
    EXPECT_EQ(patches.boundary[p], soup.boundaryOf(triangle));
    areas[triangle] += areaOf(patches, p, lattice);
  }
  const double size = soup.longest();
  for (std::size_t t = 0; t < soup.triangles.size(); ++t)
  {
    const std::uint32_t triangle = surface.given[t];
    const double area = namesAVertexTwice(surface.triangles[t]) ? 0 : soup.area(triangle);
    EXPECT_NEAR(areas[triangle], area, 1e-9 * size * size + 100 * lattice.step() * size);
  }
}

class PatchesOf : public ::testing::TestWithParam<NamedShape>
{
};

}

TEST_P(PatchesOf, AreWatertightAndCoverTheSurface)
{
  const Soup& soup = GetParam().soup;
  for (const double cells : { 0.3, 2.0, 5.7 })
  {
    for (const int levels : { 0, 2 })
    {
      SCOPED_TRACE(std::to_string(cells) + " cells, depth " + std::to_string(levels));
      const PreparedSurface prepared = prepare(soup, cellsAlongLongest(soup, cells));
      const Patches patches = patchesOf(prepared, depth(levels));
      expectWatertight(patches);
      expectCovered(patches, prepared.surface, soup);
    }
  }
}

INSTANTIATE_TEST_SUITE_P(Clean, PatchesOf, ::testing::ValuesIn(cleanShapes()), nameOf);
INSTANTIATE_TEST_SUITE_P(Thin, PatchesOf, ::testing::ValuesIn(thinShapes()), nameOf);

// Overlapping, touching and without volume: but closed.
TEST(Patches, OfClosedSoupsAreWatertight)
{
  for (unsigned seed = 0; seed < repeats(100); ++seed)
  {
    SCOPED_TRACE(seed);
    const int width = 1 + static_cast<int>(seed % 12);
    const Soup soup = randomTetrahedra(seed, 4, width);
    std::vector<Level> all;
    for (int i = 0; i <= width + 1; ++i)
    {
      all.push_back(static_cast<Level>(2 * i));
    }
    expectWatertight(patchesOf(prepareOnLevels(soup, { { all, all, all } }), {}));
  }
}

// 2^-13 of the smallest boxes, which are 2^-6 of global boxes or less.
TEST(Patches, KeepClearOfPlanesByAShareOfTheSmallestBoxes)
{
  constexpr Level Width = 1U << 30;
  Surface surface;
  surface.vertices = { { 1, 1, 1 }, { 2 * Width - 1, 2 * Width - 1, 2 * Width - 1 } };
  Boxes boxes;
  boxes.planes.lines.fill({ 0, Width, 2 * Width });
  EXPECT_EQ(PlaneClearance(surface, boxes.planes).of(0, 1), (Width >> 19) + 1);
  for (int level = 6; level <= DeepestLevel; ++level)
  {
    boxes.planes.planeLevel = level;
    const Level smallest = Width >> level;
    EXPECT_EQ(PlaneClearance(surface, boxes.planes).of(0, 1), (smallest >> 13) + 1);
  }
}
