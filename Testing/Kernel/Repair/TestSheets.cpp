// Sheets: which triangles belong together, and how each is turned.
#include "Repair/ManifoldComponents.h"
#include "Support/Pipeline.h"

using namespace cartesian;

namespace
{

// With some triangles flipped, which `flipped` tells.
Surface flippedAtRandom(const Soup& soup, unsigned seed, std::vector<bool>& flipped)
{
  Surface surface = prepare(soup, cellsAlongLongest(soup, 2)).surface;
  std::mt19937 random(seed);
  for (auto& triangle : surface.triangles)
  {
    flipped.push_back(random() % 2 == 0);
    if (flipped.back())
    {
      std::swap(triangle[1], triangle[2]);
    }
  }
  return surface;
}

}

TEST(Sheets, FindWhichTrianglesWereFlipped)
{
  Execution execution;
  const Soup soup = torus(6, 1, 0.3);
  for (unsigned seed = 0; seed < 10; ++seed)
  {
    std::vector<bool> flipped;
    const Surface surface = flippedAtRandom(soup, seed, flipped);
    const ManifoldComponents sheets(surface, SurfaceEdges(surface, execution), execution);
    EXPECT_TRUE(sheets.closed(0));
    for (std::size_t t = 0; t < flipped.size(); ++t)
    {
      ASSERT_EQ(sheets.of(t), 0u);
      ASSERT_EQ(sheets.turned(t), flipped[t] != flipped[0]);
    }
  }
}

TEST(Sheets, OfSeparateBodiesAreSeparate)
{
  Execution execution;
  Soup soup = cube();
  soup.add(cube().moved({ 2, 0, 0 }));
  std::vector<bool> flipped;
  const Surface surface = flippedAtRandom(soup, 1, flipped);
  const ManifoldComponents sheets(surface, SurfaceEdges(surface, execution), execution);
  for (std::size_t t = 0; t < 24; ++t)
  {
    EXPECT_EQ(sheets.of(t), t < 12 ? 0u : 12u);
  }
}

TEST(Sheets, WithABorderAreOpen)
{
  Execution execution;
  Surface surface = prepare(cube(), cellsOf(0.5)).surface;
  surface.triangles.pop_back();
  EXPECT_FALSE(ManifoldComponents(surface, SurfaceEdges(surface, execution), execution).closed(0));
}
