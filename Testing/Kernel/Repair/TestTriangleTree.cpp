// The tree of bounds visits each pair of triangles whose bounds meet exactly once.
#include "Repair/TriangleTree.h"
#include "Support/Pipeline.h"

#include <set>

using namespace cartesian;

namespace
{

using Pairs = std::multiset<std::pair<std::uint32_t, std::uint32_t>>;

Pairs allPairs(const Surface& surface)
{
  Pairs pairs;
  for (std::uint32_t a = 0; a < surface.triangles.size(); ++a)
  {
    for (std::uint32_t b = a + 1; b < surface.triangles.size(); ++b)
    {
      const Corners p = surface.corners(a);
      const Corners q = surface.corners(b);
      bool meet = true;
      for (std::size_t axis = 0; axis < 3; ++axis)
      {
        const auto [lowP, highP] = std::minmax({ p[0][axis], p[1][axis], p[2][axis] });
        const auto [lowQ, highQ] = std::minmax({ q[0][axis], q[1][axis], q[2][axis] });
        meet = meet && lowP <= highQ && lowQ <= highP;
      }
      if (meet)
      {
        pairs.emplace(a, b);
      }
    }
  }
  return pairs;
}

}

TEST(TriangleTree, VisitsEachPairOnce)
{
  Execution execution;
  for (const Soup& soup : { cube(), bumpySphere(1, 3), needle(), comb(5), torus(5, 1, 0.2) })
  {
    const Surface surface = prepare(soup, cellsAlongLongest(soup, 3)).surface;
    const TriangleTree tree(surface, execution);
    ASSERT_EQ(tree.size(), surface.triangles.size());
    Pairs visited;
    for (std::size_t place = 0; place < tree.size(); ++place)
    {
      tree.forEachLarger(place, [&](std::uint32_t other) {
        visited.insert(std::minmax(tree.triangle(place), other));
        return true;
      });
    }
    EXPECT_EQ(visited, allPairs(surface));
  }
}
