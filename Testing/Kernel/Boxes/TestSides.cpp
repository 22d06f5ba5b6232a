// The sides of a box that becomes a polyhedron cover it, and belong to two boxes each.
#include "Boxes/Sides.h"
#include "Support/Pipeline.h"

#include <gtest/gtest.h>

using namespace cartesian;

TEST(Sides, CoverEachPolyhedralBoxOnce)
{
  const Soup soup = sphere(8, 1).turned();
  Execution execution;
  const PreparedSurface prepared = prepare(soup, cellsAlongLongest(soup, 6));
  const BoxedSurface boxed = boxSurface(prepared, depth(1), execution);
  const Boxes& boxes = boxed.boxes;
  const Sides sides = findSides(boxes, execution);
  ASSERT_FALSE(sides.polyhedral.empty());
  for (std::size_t n = 0; n < sides.polyhedral.size(); ++n)
  {
    const std::uint32_t b = sides.polyhedral[n];
    std::array<std::int64_t, 6> areas{};
    for (std::size_t i = sides.boxStart[n]; i < sides.boxStart[n + 1]; ++i)
    {
      const Side& side = sides.sides[sides.ofBox[i].side];
      const bool upper = sides.ofBox[i].upper != 0;
      EXPECT_EQ(upper ? side.low : side.high, b);
      areas[2u * side.axis + (upper ? 1u : 0u)] += std::int64_t(side.size[0]) * side.size[1];
    }
    const PackedBox& box = boxes.boxes[b];
    for (int axis = 0; axis < 3; ++axis)
    {
      const std::int64_t whole =
        Boxes::fineSize(box, (axis + 1) % 3) * Boxes::fineSize(box, (axis + 2) % 3);
      for (const std::int64_t area : { areas[2u * unsigned(axis)], areas[2u * unsigned(axis) + 1] })
      {
        EXPECT_TRUE(area == whole) << b;
      }
    }
  }
}
