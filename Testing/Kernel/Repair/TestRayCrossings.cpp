// Many lines cross the same triangles at the same levels as each by itself.
#include "Repair/RayCrossings.h"
#include "Support/Pipeline.h"

using namespace cartesian;

TEST(RayCrossings, OfManyLinesAreThoseOfEach)
{
  Execution execution;
  std::mt19937 random(1);
  for (const Soup& soup : { cube(), bumpySphere(2, 3), needle(), comb(5), torus(5, 1, 0.2) })
  {
    const Surface surface = prepare(soup.turned(), cellsAlongLongest(soup, 3)).surface;
    const TriangleTree tree(surface, execution);
    std::size_t crossed = 0;
    for (std::size_t along = 0; along < 3; ++along)
    {
      std::vector<Point> places(2000);
      for (Point& place : places)
      {
        const Point& a = surface.vertices[random() % surface.vertices.size()];
        const Point& b = surface.vertices[random() % surface.vertices.size()];
        for (std::size_t axis = 0; axis < 3; ++axis)
        {
          place[axis] = static_cast<Level>((std::uint64_t(a[axis]) + b[axis]) / 4 * 2);
        }
      }
      const Buckets<NumberedCrossing> all = crossingsOf(surface, tree, along, places, execution);
      ASSERT_EQ(places.size(), 2000u);
      for (std::size_t i = 0; i < places.size(); ++i)
      {
        const std::vector<RayCrossing> each = crossingsOf(surface, tree, along, places[i]);
        ASSERT_TRUE(std::equal(all.begin(i), all.end(i), each.begin(), each.end(),
          [&](const NumberedCrossing& a, const RayCrossing& b) {
            return a.line == i && a.level == b.level && a.triangle == b.triangle && a.up == b.up;
          }));
        crossed += each.size();
      }
    }
    EXPECT_GT(crossed, 0u);
  }
}
