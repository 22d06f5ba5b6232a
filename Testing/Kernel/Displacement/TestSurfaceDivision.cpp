// Divided surfaces: the same body, in triangles that are small enough and still meet edge to edge.
#include "Displacement/SurfaceDivision.h"
#include "Support/Pipeline.h"

#include <map>

using namespace cartesian;

namespace
{

void expectDivided(const Soup& soup, double parts)
{
  const Surface before = prepare(soup, cellsAlongLongest(soup, 3)).surface;
  Surface surface = before;
  const double longest = soup.longest() / parts / surface.lattice.step();
  divideTriangles(surface, longest);
  EXPECT_GT(surface.triangles.size(), before.triangles.size());
  EXPECT_NEAR(volumeOf(surface) / volumeOf(before), 1, 1e-6);
  EXPECT_NEAR(areaOf(surface) / areaOf(before), 1, 1e-6);
  ASSERT_EQ(surface.boundary.size(), surface.triangles.size());
  ASSERT_EQ(surface.given.size(), surface.triangles.size());
  std::map<std::pair<std::uint32_t, std::uint32_t>, int> edges;
  for (const auto& t : surface.triangles)
  {
    for (std::size_t i = 0; i < 3; ++i)
    {
      const std::uint32_t from = t[i];
      const std::uint32_t to = t[(i + 1) % 3];
      ++edges[{ from, to }];
      --edges[{ to, from }];
      EXPECT_LE(norm(minus(surface.vertices[from], surface.vertices[to])), longest);
    }
  }
  for (const auto& edge : edges)
  {
    EXPECT_EQ(edge.second, 0);
  }
}

}

TEST(SurfaceDivision, KeepsTheBodyAndClosesEverywhere)
{
  expectDivided(cube(), 7);
  expectDivided(cube().turned(), 13);
  expectDivided(sphere(5, 1), 20);
}

TEST(SurfaceDivision, PartsKeepBoundaryAndNumber)
{
  const Soup soup = cube();
  const Surface before = prepare(soup, cellsAlongLongest(soup, 3)).surface;
  Surface surface = before;
  divideTriangles(surface, soup.longest() / 9 / surface.lattice.step());
  std::map<std::uint32_t, std::int32_t> boundaryOf;
  for (std::size_t t = 0; t < before.triangles.size(); ++t)
  {
    boundaryOf[before.given[t]] = before.boundary[t];
  }
  for (std::size_t t = 0; t < surface.triangles.size(); ++t)
  {
    EXPECT_EQ(surface.boundary[t], boundaryOf.at(surface.given[t]));
  }
}

TEST(SurfaceDivision, LeavesShortEdgesAlone)
{
  const Soup soup = sphere(5, 1);
  const Surface before = prepare(soup, cellsAlongLongest(soup, 3)).surface;
  Surface surface = before;
  divideTriangles(surface, 2 * soup.longest() / surface.lattice.step());
  EXPECT_EQ(surface.triangles, before.triangles);
  EXPECT_EQ(surface.vertices, before.vertices);
}
