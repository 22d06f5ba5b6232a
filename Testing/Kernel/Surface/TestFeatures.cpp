// Edges, connected components and sharp features of surfaces of which they are known.
#include "Support/Pipeline.h"
#include "Surface/Components.h"
#include "Surface/Features.h"
#include "Surface/SurfaceEdges.h"

#include <set>

using namespace cartesian;

namespace
{

Surface surfaceOf(const Soup& soup)
{
  return prepare(soup, cellsAlongLongest(soup, 3)).surface;
}

// Sharp edges, each counted from both of its triangles.
std::size_t sharpSides(const Surface& surface, double featureAngle)
{
  Execution execution;
  const Features features = findFeatures(surface, featureAngle, execution);
  std::size_t count = 0;
  for (std::size_t t = 0; t < surface.triangles.size(); ++t)
  {
    for (unsigned edge = 0; edge < 3; ++edge)
    {
      count += features.isSharp(t, edge);
    }
  }
  return count;
}

Soup oneBoundary(Soup soup)
{
  soup.boundary.assign(soup.triangles.size(), 0);
  return soup;
}

}

TEST(Features, OfALongTubeAreItsRims)
{
  const Soup tube = oneBoundary(tubeWithEnds(12, 6, 30));
  for (const double radius : { 0.1, 1.0, 30.0 })
  {
    for (const Soup& soup : { tube, oneBoundary(tubeWithEnds(24, 8, 100)), tube.turned(0, 20),
           tube.turned(), tube.permuted({ 2, 0, 1 }) })
    {
      const Surface surface = surfaceOf(soup.scaled(radius));
      const std::size_t rims = soup.points.size();
      EXPECT_EQ(sharpSides(surface, 80), 2 * rims);
    }
  }
}

// The riser of a step is as thin as a fold, but stands upright: it has the edges of one that is high.
TEST(Features, OfALowStepAreThoseOfAHighOne)
{
  const auto step = [](double height) {
    const std::array<std::vector<double>, 3> lines{ { { 0, 1, 2 }, { 0, 1 },
      { 0, 1, 1 + height } } };
    return voxels(lines, [](int i, int, int k) { return k == 0 || i == 0; });
  };
  for (const double degrees : { 0.0, 20.0, 45.0, 70.0 })
  {
    EXPECT_EQ(sharpSides(surfaceOf(step(0.01).turned(1, degrees)), 30),
      sharpSides(surfaceOf(step(0.5).turned(1, degrees)), 30));
  }
}

TEST(Features, OfACubeAreItsEdges)
{
  const Surface surface = surfaceOf(cube());
  EXPECT_EQ(sharpSides(surface, 89), 24u);
  EXPECT_EQ(sharpSides(surface, 91), 0u);
}

TEST(Features, OfASphereAreFewerForLargerAngles)
{
  const Surface surface = surfaceOf(sphere(4, 1));
  EXPECT_EQ(sharpSides(surface, 60), 0u);
  EXPECT_EQ(sharpSides(surface, 0), 3 * surface.triangles.size());
}

TEST(Features, OpenEdgesAreSharp)
{
  Surface surface = surfaceOf(cube());
  surface.triangles.pop_back();
  surface.boundary.pop_back();
  EXPECT_EQ(sharpSides(surface, 180), 3u);
}

TEST(SurfaceEdges, OfClosedSurfacesHaveTwoOppositeUses)
{
  Execution execution;
  for (const NamedShape& shape : cleanShapes())
  {
    const Surface surface = surfaceOf(shape.soup);
    std::size_t uses = 0;
    SurfaceEdges(surface, execution)
      .forEach([&](std::uint32_t lower, const EdgeUse* begin, const EdgeUse* end) {
        const auto down = std::count_if(begin, end, [](const EdgeUse& use) { return use.down(); });
        EXPECT_EQ(2 * down, end - begin) << shape.name;
        EXPECT_LT(lower, begin->upper);
        uses += static_cast<std::size_t>(end - begin);
      });
    EXPECT_EQ(uses, 3 * surface.triangles.size()) << shape.name;
  }
}

TEST(Components, AreAsManyAsBodies)
{
  Soup soup;
  for (int n = 1; n <= 4; ++n)
  {
    soup.add(sphere(2, 1).moved({ 3.0 * n, 0, 0 }));
    const Surface surface = surfaceOf(soup);
    DisjointSets components = connectedComponents(surface);
    std::set<std::uint32_t> found;
    for (std::uint32_t v = 0; v < surface.vertices.size(); ++v)
    {
      found.insert(components.find(v));
    }
    EXPECT_EQ(found.size(), static_cast<std::size_t>(n));
  }
}
