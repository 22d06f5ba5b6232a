// Boxes of a grid that goes on beyond its ends with those at its other ends: levels are balanced across the ends too.
#include "Boxes/Balance.h"
#include "Support/Pipeline.h"

#include <set>

namespace cartesian
{
namespace
{

using Index = std::array<int, 3>;

// Where a box is, in the fine grid, and its levels.
using Placed = std::pair<FinePoint, std::array<std::uint8_t, 3>>;

// A grid of unit boxes around a ball in one of them, which is refined.
class BallInAGrid
{
public:
  BallInAGrid(
    const Index& counts, const Index& at, const RefinementSpec& refinement, int zoneDepth = 0)
    : options_(asTheyAre(0, refinement))
    , soup_(sphere(4, 0.3).moved({ at[0] + 0.47, at[1] + 0.52, at[2] + 0.49 }))
    , zone_(box(
        { at[0] + 0.39, at[1] + 0.05, at[2] + 0.22 }, { at[0] + 0.93, at[1] + 0.9, at[2] + 0.8 }))
  {
    options_.domain.domain = Domain::Outside;
    options_.domain.boxFrom = BoxSource::Bounds;
    options_.domain.bounds = { { 0, 0, 0 }, { 1. * counts[0], 1. * counts[1], 1. * counts[2] } };
    options_.grid = cellsOf(1);
    options_.memoryLimit = PlentyOfMemory;
    if (options_.refinement.boundaries.empty())
    {
      options_.refinement.boundaries = { { 0, 3 } };
    }
    if (zoneDepth > 0)
    {
      options_.refinement.regions.push_back({ zone_.view(), zoneDepth });
    }
    prepared_ = prepareSurface(soup_.view(), options_, execution_);
    decomposition_ = decompose(prepared_, options_, execution_);
  }

  SlabRange all() const { return decomposition_->allLayers(); }
  Boxes boxes() const { return boxes(all()); }
  Boxes boxes(SlabRange core, int threads = 1) const
  {
    Execution execution(threads);
    return decomposition_->boxes(core, execution);
  }

private:
  Execution execution_;
  TestOptions options_;
  Soup soup_;
  Soup zone_; // in the same box
  PreparedSurface prepared_;
  std::unique_ptr<Decomposition> decomposition_;
};

RefinementSpec periodic(unsigned axes, int transitionLayers = 1, bool isotropic = false)
{
  RefinementSpec spec;
  spec.periodic = axes;
  spec.transitionLayers = transitionLayers;
  spec.isotropic = isotropic;
  return spec;
}

std::int64_t countAlong(const Boxes& boxes, std::size_t axis)
{
  return static_cast<std::int64_t>(boxes.planes[axis].size()) - 1;
}

// With the grid turned, so that the boxes from `first` on come first.
std::set<Placed> placed(const Boxes& boxes, const Index& first = {})
{
  std::set<Placed> result;
  for (const PackedBox& box : boxes.packed)
  {
    FinePoint low = boxes.fineLow(box);
    for (std::size_t axis = 0; axis < 3; ++axis)
    {
      const std::int64_t length = countAlong(boxes, axis) * FinePerBox;
      low[axis] = (low[axis] - first[axis] * FinePerBox + length) % length;
    }
    result.insert({ low, box.level });
  }
  return result;
}

bool overlap(const Boxes& boxes, const PackedBox& a, const PackedBox& b, int axis)
{
  const std::int64_t lowA = boxes.fineLow(a)[axis];
  const std::int64_t lowB = boxes.fineLow(b)[axis];
  return lowA < lowB + Boxes::fineSize(b, axis) && lowB < lowA + Boxes::fineSize(a, axis);
}

// The largest difference of the levels of boxes that face each other at opposite ends of the grid.
int largestDifference(const Boxes& boxes, int axis)
{
  std::vector<PackedBox> low;
  std::vector<PackedBox> high;
  for (const PackedBox& box : boxes.packed)
  {
    const std::int64_t at = boxes.fineLow(box)[axis];
    const bool isLast =
      at + Boxes::fineSize(box, axis) == countAlong(boxes, std::size_t(axis)) * FinePerBox;
    (at == 0 ? low : high).push_back(box);
    if (at != 0 && !isLast)
    {
      high.pop_back();
    }
  }
  int result = 0;
  for (const PackedBox& a : low)
  {
    for (const PackedBox& b : high)
    {
      const bool face =
        overlap(boxes, a, b, (axis + 1) % 3) && overlap(boxes, a, b, (axis + 2) % 3);
      for (std::size_t along = 0; face && along < 3; ++along)
      {
        result = std::max(result, std::abs(a.level[along] - b.level[along]));
      }
    }
  }
  return result;
}

TEST(EndlessGrid, EndsOrGoesOn)
{
  Meshlines planes;
  planes[0] = { 0, 2, 4, 6 };
  planes[1] = { 0, 2 };
  planes[2] = { 0, 2, 4 };
  const EndlessGrid grid(0b011, planes);
  using At = std::array<std::int64_t, 3>;
  EXPECT_EQ(grid.seen({ -1, -1, -1 }), (At{ 2, 0, -1 }));
  EXPECT_EQ(grid.seen({ 3, 1, 2 }), (At{ 0, 0, 2 }));
  EXPECT_EQ(grid.seen({ 1, 0, 1 }), (At{ 1, 0, 1 }));
  EXPECT_EQ(EndlessGrid().seen({ -1, 3, 5 }), (At{ -1, 3, 5 }));
}

TEST(EndlessGrid, LevelsAtItsEndsAreBalanced)
{
  for (const int axis : { 0, 1, 2 })
  {
    for (const int end : { 0, 3 })
    {
      SCOPED_TRACE(std::to_string(axis) + ", " + std::to_string(end));
      Index at = { 1, 1, 1 };
      at[std::size_t(axis)] = end;
      const auto differenceWith = [&](const RefinementSpec& spec) {
        return largestDifference(BallInAGrid({ 4, 4, 4 }, at, spec).boxes(), axis);
      };
      EXPECT_GT(differenceWith(periodic(0)), 1);
      EXPECT_GT(differenceWith(periodic(0b111 & ~(1u << axis))), 1);
      EXPECT_EQ(differenceWith(periodic(1u << axis)), 1);
      EXPECT_EQ(differenceWith(periodic(0b111)), 1);
      EXPECT_EQ(differenceWith(periodic(0b111, 1, true)), 1);
    }
  }
}

// Boxes around a ball are the same wherever it is, but that the grid begins elsewhere: so there are as many transition
// layers, and blocks beyond each end are visited in each pass.
TEST(EndlessGrid, BoxesAreTheSameWhereverItBegins)
{
  const Index counts = { 4, 5, 3 };
  const Index middle = { 2, 2, 1 };
  for (unsigned axes = 0; axes < 8; ++axes)
  {
    for (const auto& [depth, layers] : { std::pair(3, 1), std::pair(3, 3), std::pair(5, 1) })
    {
      RefinementSpec spec = periodic(axes, layers, axes % 2 == 0);
      spec.boundaries = { { 0, depth } };
      const int zoneDepth = depth - 1;
      const std::set<Placed> expected =
        placed(BallInAGrid(counts, middle, spec, zoneDepth).boxes());
      for (const unsigned upper : { 0u, 1u, 2u, 4u, 7u })
      {
        Index at = middle;
        Index first = {};
        for (std::size_t axis = 0; axis < 3; ++axis)
        {
          const bool moves = (axes >> axis & 1) != 0;
          at[axis] = !moves ? middle[axis] : (upper >> axis & 1) != 0 ? counts[axis] - 1 : 0;
          first[axis] = at[axis] - middle[axis];
        }
        EXPECT_TRUE(placed(BallInAGrid(counts, at, spec, zoneDepth).boxes(), first) == expected)
          << axes << ", " << depth << ", " << layers << ", " << upper;
      }
    }
  }
}

// Two tiny regions, so deep that they are blocks of parts of global boxes, face each other.
TEST(EndlessGrid, DeepBlocksAtItsEndsAreBalanced)
{
  for (const bool isAcross : { false, true })
  {
    const Soup low = box({ 0.02, 1.4, 1.4 }, { 0.1, 1.45, 1.45 });
    const Soup high = box({ 3.9, 1.4, 1.4 }, { 3.98, 1.45, 1.45 });
    RefinementSpec spec = periodic(isAcross ? 0b001 : 0b110);
    spec.regions.push_back({ low.view(), 6 });
    spec.regions.push_back({ high.view(), 4 });
    const int difference =
      largestDifference(BallInAGrid({ 4, 4, 4 }, { 1, 2, 2 }, spec).boxes(), 0);
    EXPECT_EQ(difference, isAcross ? 1 : 2);
  }
}

TEST(EndlessGrid, MayBeOneBoxAcross)
{
  const Boxes boxes = BallInAGrid({ 1, 4, 1 }, { 0, 0, 0 }, periodic(0b111)).boxes();
  for (const int axis : { 0, 1, 2 })
  {
    EXPECT_LE(largestDifference(boxes, axis), 1);
  }
}

TEST(EndlessGrid, BoxesAreTheSameForAnyNumberOfThreads)
{
  const BallInAGrid ball({ 8, 8, 8 }, { 0, 7, 3 }, periodic(0b111, 2));
  EXPECT_TRUE(placed(ball.boxes()) == placed(ball.boxes(ball.all(), 3)));
}

// The layers of each part, of which those at one end see those at the other.
TEST(EndlessGrid, BoxesAreTheSameInParts)
{
  for (const int end : { 0, 59 })
  {
    const BallInAGrid ball({ 2, 2, 60 }, { 0, 1, end }, periodic(0b100, 3));
    const Boxes whole = ball.boxes();
    EXPECT_GT(whole.globals[whole.rowStart[whole.row(0, end == 0 ? 59 : 0)]].depth, 0);
    for (std::uint32_t k = 0; k < 60; ++k)
    {
      const Boxes part = ball.boxes({ k, k + 1 });
      EXPECT_LT(part.kept.end - part.kept.begin, 30u);
      const std::uint32_t first = whole.firstBoxOf(part.kept.begin);
      ASSERT_EQ(first + part.packed.size(), whole.firstBoxOf(part.kept.end));
      for (std::size_t b = 0; b < part.packed.size(); ++b)
      {
        const PackedBox& same = whole.packed[first + b];
        ASSERT_EQ(part.fineLow(part.packed[b]), whole.fineLow(same)) << k;
        ASSERT_EQ(part.packed[b].level, same.level) << k;
        ASSERT_EQ(part.packed[b].corners, same.corners) << k;
      }
    }
  }
}

}
}
