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
