// How large a mesh is expected to be, against what is made.
#include "Lattice/Vector.h"
#include "Support/Pipeline.h"
#include "Surface/SizeEstimate.h"

using namespace cartesian;

namespace
{

double boxesOf(const Soup& soup, double size, int deepest)
{
  Execution execution;
  return static_cast<double>(
    boxSurface(prepare(soup, cellsOf(size)), depth(deepest), execution).boxes.packed.size());
}

}

TEST(SizeEstimate, ASphereHasItsVolumeAndShadows)
{
  for (const Soup& soup : { sphere(30, 2), sphere(30, 2).flipped().moved({ 1e6, 0, -1e6 }) })
  {
    const SurfaceSize size = sizeOf(soup.view());
    EXPECT_NEAR(size.longest, 4, 0.01);
    EXPECT_NEAR(size.volume, 32 * Pi / 3, 0.1);
    for (const double shadow : size.shadows)
    {
      EXPECT_NEAR(shadow, 8 * Pi, 0.1); // of both halves
    }
  }
}

TEST(SizeEstimate, LongBoxesHaveTheirShadows)
{
  const SurfaceSize size = sizeOf(box({ 0, 0, 0 }, { 1, 2, 4 }).view());
  EXPECT_DOUBLE_EQ(size.volume, 8);
  EXPECT_EQ(size.shadows, (std::array<double, 3>{ 16, 8, 4 }));
  // 8 / 0.001, and half of 16 / 0.01, 8 / 0.01, 4 / 0.01.
  EXPECT_NEAR(expectedBoxes(size, { 0.1, 0.1, 0.1 }, 0), 8000 + 1400, 1e-6);
  // 8 / 0.002, and half of 16 / 0.02, 8 / 0.02, 4 / 0.01.
  EXPECT_NEAR(expectedBoxes(size, { 0.1, 0.1, 0.2 }, 0), 4000 + 800, 1e-6);
}

TEST(SizeEstimate, AsManyBoxesAreMade)
{
  for (const Soup& soup :
    { sphere(20, 1), torus(40, 1, 0.4), cube().turned(), bumpySphere(3, 20), sphere(20, 1e-3) })
  {
    const SurfaceSize surface = sizeOf(soup.view());
    for (const double cells : { 20, 50 })
    {
      for (const int deepest : { 0, 1, 2 })
      {
        const double size = surface.longest / cells;
        const double expected = expectedBoxes(surface, { size, size, size }, deepest);
        const double made = boxesOf(soup, size, deepest);
        EXPECT_NEAR(expected / made, 1, 0.1) << made << " boxes, depth " << deepest;
      }
    }
  }
}
