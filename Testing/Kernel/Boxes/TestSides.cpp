// The common sides of boxes: they cover each box once, and both boxes of a side know it.
#include "Boxes/Sides.h"
#include "Support/Pipeline.h"

#include <gtest/gtest.h>

using namespace cartesian;

namespace
{

// What the sides of a polyhedral box cover of each of its six faces, in fine squares.
std::array<std::int64_t, 6> coveredBy(const Sides& sides, std::size_t n)
{
  std::array<std::int64_t, 6> covered{};
  for (std::size_t i = sides.boxStart[n]; i < sides.boxStart[n + 1]; ++i)
  {
    const SideOfBox use = sides.ofBox[i];
    const Side& side = sides.common[use.side];
    EXPECT_EQ(use.upper != 0 ? side.low : side.high, sides.polyhedral[n]);
    covered[2u * side.axis + use.upper] += side.size(0) * side.size(1);
  }
  return covered;
}

void expectCovered(const Boxes& boxes, const Sides& sides)
{
  for (std::size_t n = 0; n < sides.polyhedral.size(); ++n)
  {
    const PackedBox& box = boxes.packed[sides.polyhedral[n]];
    const auto covered = coveredBy(sides, n);
    for (int axis = 0; axis < 3; ++axis)
    {
      const std::int64_t area =
        Boxes::fineSize(box, (axis + 1) % 3) * Boxes::fineSize(box, (axis + 2) % 3);
      ASSERT_EQ(covered[static_cast<std::size_t>(2 * axis)], area);
      ASSERT_EQ(covered[static_cast<std::size_t>(2 * axis + 1)], area);
    }
  }
}

}

TEST(Sides, CoverEachPolyhedralBoxOnce)
{
  for (const int levels : { 0, 1, 3 })
  {
    const Soup soup = sphere(6, 1).turned();
    const Meshed meshed = meshOf(soup, cellsAlongLongest(soup, 6), asTheyAre(0, depth(levels)));
    const Boxes& boxes = meshed.boxed.boxes;
    Execution execution;
    const Sides sides = findSides(boxes, execution);
    ASSERT_FALSE(sides.polyhedral.empty());
    expectCovered(boxes, sides);
  }
}

TEST(Sides, AreTheSameForAnyNumberOfThreads)
{
  const Soup soup = torus(8, 1, 0.4).turned();
  const Meshed meshed = meshOf(soup, cellsAlongLongest(soup, 9), asTheyAre(0, depth(2)));
  Execution one;
  Execution three(3);
  const Sides sides = findSides(meshed.boxed.boxes, one);
  const Sides same = findSides(meshed.boxed.boxes, three);
  EXPECT_EQ(sides.polyhedral, same.polyhedral);
  EXPECT_EQ(sides.ownStart, same.ownStart);
  EXPECT_EQ(sides.boxStart, same.boxStart);
  ASSERT_EQ(sides.common.size(), same.common.size());
  for (std::size_t s = 0; s < sides.common.size(); ++s)
  {
    EXPECT_EQ(sides.common[s].low, same.common[s].low);
    EXPECT_EQ(sides.common[s].high, same.common[s].high);
    EXPECT_EQ(sides.common[s].corner, same.common[s].corner);
    EXPECT_EQ(sides.common[s].level, same.common[s].level);
  }
}
