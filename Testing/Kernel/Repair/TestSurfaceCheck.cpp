// Open, inconsistent and non-manifold edges are counted and located.
#include "Support/Pipeline.h"

#include <gtest/gtest.h>

using namespace cartesian;

namespace
{

SurfaceCheck checkOf(const Soup& soup)
{
  return prepare(soup, cellsAlongLongest(soup, 2)).repair.check;
}

}

TEST(SurfaceCheck, CleanShapesAreClosedAndOriented)
{
  for (const NamedShape& shape : cleanShapes())
  {
    const SurfaceCheck check = checkOf(shape.soup);
    EXPECT_TRUE(check.closed()) << shape.name;
    EXPECT_TRUE(check.oriented()) << shape.name;
    const bool touches = shape.name == "BoxesTouchingInAnEdge";
    EXPECT_EQ(check.nonManifoldEdges, touches ? 12U : 0U) << shape.name;
    EXPECT_EQ(check.places.empty(), !touches) << shape.name;
  }
}

TEST(SurfaceCheck, AMissingTriangleOpensThreeEdges)
{
  Soup soup = sphere(3, 1);
  soup.triangles.erase(soup.triangles.begin() + 7);
  soup.boundary.clear();
  const SurfaceCheck check = checkOf(soup);
  EXPECT_EQ(check.openEdges, 3U);
  EXPECT_EQ(check.nonManifoldEdges, 0U);
  EXPECT_EQ(check.inconsistentEdges, 0U);
  ASSERT_EQ(check.places.size(), 3U);
  EXPECT_STREQ(check.places[0].what, "open");
}

// Orientation (Orientation.h) leaves only one-sided surfaces inconsistent.
TEST(SurfaceCheck, AKleinBottleCannotBeOriented)
{
  const SurfaceCheck check = checkOf(kleinBottle(24));
  EXPECT_TRUE(check.closed());
  EXPECT_FALSE(check.oriented());
  EXPECT_GT(check.inconsistentEdges, 0U);
  ASSERT_FALSE(check.places.empty());
  EXPECT_STREQ(check.places[0].what, "inconsistently oriented");
}

TEST(SurfaceCheck, AFinMakesAnEdgeOfThree)
{
  Soup soup = sphere(3, 1);
  soup.boundary.clear();
  soup.points.push_back({ 5, 5, 5 });
  soup.triangles.push_back({ soup.triangles[5][0], soup.triangles[5][1],
    static_cast<std::uint32_t>(soup.points.size() - 1) });
  const SurfaceCheck check = checkOf(soup);
  EXPECT_EQ(check.openEdges, 3U);
  EXPECT_EQ(check.nonManifoldEdges, 1U);
}

TEST(SurfaceCheck, OnlyAFewPlacesAreKept)
{
  Soup soup = sphere(6, 1);
  soup.triangles.resize(soup.triangles.size() / 2);
  soup.boundary.clear();
  const SurfaceCheck check = checkOf(soup);
  EXPECT_GT(check.openEdges, SurfaceCheck::MostPlaces);
  EXPECT_EQ(check.places.size(), SurfaceCheck::MostPlaces);
}

// Each triangle has its own points, as in an STL file.
TEST(SurfaceCheck, PointsThatCoincideAreOne)
{
  const Soup soup = sphere(4, 1);
  Soup apart;
  for (const auto& t : soup.triangles)
  {
    const auto first = static_cast<std::uint32_t>(apart.points.size());
    for (const std::uint32_t p : t)
    {
      apart.points.push_back(soup.points[p]);
    }
    apart.triangles.push_back({ first, first + 1, first + 2 });
  }
  EXPECT_TRUE(checkOf(apart).oriented());
  EXPECT_EQ(prepare(apart, {}).surface.vertices.size(), soup.points.size());
}

// Degenerate triangles neither close nor open anything.
TEST(SurfaceCheck, DegenerateTrianglesDoNotCount)
{
  Soup soup = cube();
  soup.boundary.clear();
  soup.triangles.push_back({ 0, 0, 1 });
  soup.triangles.push_back({ 2, 2, 2 });
  EXPECT_TRUE(checkOf(soup).oriented());
}

TEST(SurfaceCheck, NormalsInwardAreTurned)
{
  const PreparedSurface prepared = prepare(sphere(4, 1).flipped(), {});
  EXPECT_NEAR(volumeOf(prepared.surface), sphere(4, 1).volume(), 1e-8);
}

TEST(SurfaceCheck, AreaAndVolumeInUserUnits)
{
  const Soup soup = bumpySphere(4, 6).scaled(1e-3).moved({ 5, 6, 7 });
  const PreparedSurface prepared = prepare(soup, {});
  EXPECT_NEAR(volumeOf(prepared.surface) / soup.volume(), 1, 1e-7);
  EXPECT_NEAR(areaOf(prepared.surface) / soup.area(), 1, 1e-7);
}
