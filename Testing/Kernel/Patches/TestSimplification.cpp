// Nodes and edges that a flat surface does not need vanish; those of a roof stay.
#include "Patches/Simplification.h"
#include "Support/Pipeline.h"

#include <gtest/gtest.h>

using namespace cartesian;

namespace
{

// A grid of 4 x 4 squares over the lower face of a box, halved into triangles; `height` of a node in half
// squares. Returns the number of corners of each polygon that is left.
std::vector<std::size_t> simplified(const std::function<Level(int, int)>& height)
{
  Execution execution;
  const Soup soup = cube();
  const PreparedSurface prepared = prepare(soup, cellsOf(0.4));
  const BoxedSurface boxed = boxSurface(prepared, {}, execution);
  const PlaneClearance clearance(prepared.surface, boxed.boxes.planes);
  PatchSpec spec;
  Simplification simplification(prepared.surface, boxed.boxes, clearance, spec);
  const Box box = boxed.boxes.box(0);
  const Level step = (box.high[0] - box.low[0]) / 4;
  BoxSurface piece;
  std::vector<Point>& points = piece.points;
  for (int j = 0; j <= 4; ++j)
  {
    for (int i = 0; i <= 4; ++i)
    {
      points.push_back({ box.low[0] + Level(i) * step, box.low[1] + Level(j) * step,
        box.low[2] + step + height(i, j) * (step / 2) });
    }
  }
  simplification.begin(box, piece);
  const auto add = [&](const std::array<std::uint32_t, 3>& t) {
    const Vector normal =
      unit(cross(minus(points[t[1]], points[t[0]]), minus(points[t[2]], points[t[0]])));
    simplification.add(t.data(), t.data() + 3, 0, normal);
  };
  for (std::uint32_t j = 0; j < 4; ++j)
  {
    for (std::uint32_t i = 0; i < 4; ++i)
    {
      const std::uint32_t p = i + 5 * j;
      add({ p, p + 1, p + 6 });
      add({ p, p + 6, p + 5 });
    }
  }
  simplification.removeInner();
  simplification.merge();
  std::vector<std::size_t> sizes;
  simplification.forEach([&](const std::uint32_t* begin, const std::uint32_t* end, std::uint32_t) {
    sizes.push_back(static_cast<std::size_t>(end - begin));
  });
  return sizes;
}

}

// One polygon, with all nodes on the sides of the box.
TEST(Simplification, MakesAPlaneOnePolygon)
{
  EXPECT_EQ(simplified([](int, int) { return Level(0); }), std::vector<std::size_t>{ 16 });
}

// A ridge along y at i = 2 with its three inner nodes: two polygons that share five nodes.
TEST(Simplification, KeepsARidge)
{
  const auto height = [](int i, int) { return Level(i <= 2 ? i : 4 - i); };
  const std::vector<std::size_t> sizes = simplified(height);
  ASSERT_EQ(sizes.size(), 2u);
  EXPECT_EQ(sizes[0] + sizes[1], 16u + 2u + 2u * 3u);
}

// A steep ridge of three levels: its ends become the first of them.
TEST(Simplification, KeepsTheHigherKindOfPointsThatCollapse)
{
  Execution execution;
  const PreparedSurface prepared = prepare(cube(), cellsOf(0.4));
  const BoxedSurface boxed = boxSurface(prepared, {}, execution);
  const PlaneClearance clearance(prepared.surface, boxed.boxes.planes);
  Simplification simplification(prepared.surface, boxed.boxes, clearance, {});
  const Box box = boxed.boxes.box(0);
  const Level middle = (box.high[0] - box.low[0]) / 2;
  const Point top{ box.low[0] + middle, box.low[1] + middle, box.low[2] + middle };
  BoxSurface piece;
  piece.points = { box.low, { box.high[0], box.low[1], box.low[2] },
    { box.high[0], box.high[1], box.low[2] }, { box.low[0], box.high[1], box.low[2] }, top,
    { top[0] + 2, top[1], top[2] } };
  piece.kinds.assign(4, PointKind::OnSurface);
  piece.kinds.insert(piece.kinds.end(), { PointKind::OnEdge, PointKind::Corner });
  simplification.begin(box, piece);
  using Triangle = std::array<std::uint32_t, 3>;
  for (const Triangle& t : { Triangle{ 0, 1, 4 }, Triangle{ 4, 1, 5 }, Triangle{ 1, 2, 5 },
         Triangle{ 2, 3, 4 }, Triangle{ 2, 4, 5 }, Triangle{ 3, 0, 4 } })
  {
    const Vector along = minus(piece.points[t[1]], piece.points[t[0]]);
    simplification.add(
      t.data(), t.data() + 3, 0, unit(cross(along, minus(piece.points[t[2]], piece.points[t[0]]))));
  }
  simplification.removeInner();
  simplification.forEach([](const std::uint32_t* begin, const std::uint32_t* end, std::uint32_t) {
    EXPECT_EQ(std::count(begin, end, 5u), 0);
  });
  EXPECT_EQ(simplification.kinds()[4], PointKind::Corner);
}
