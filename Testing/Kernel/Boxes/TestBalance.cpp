// Balance: levels of boxes that share part of a side differ by at most one in each direction, for
// any refinement, and do not depend on threads, parts or the order of axes.
#include "Boxes/Balance.h"
#include "Support/Effort.h"
#include "Support/Pipeline.h"

#include <algorithm>

namespace cartesian
{
namespace
{

using Levels = std::array<std::uint8_t, 3>;

// Everything that a box is, apart from its number.
using Placed = std::tuple<Point, Point, Levels, std::uint8_t, BoxStatus>;

Placed placed(const Boxes& boxes, std::size_t b)
{
  const Box box = boxes.box(b);
  return { box.low, box.high, box.level, box.corners, box.status };
}

std::vector<Placed> allPlaced(const Boxes& boxes)
{
  std::vector<Placed> all;
  for (std::size_t b = 0; b < boxes.packed.size(); ++b)
  {
    all.push_back(placed(boxes, b));
  }
  return all;
}

bool shareASide(const Box& below, const Box& above, std::size_t axis)
{
  const std::size_t a = (axis + 1) % 3;
  const std::size_t b = (axis + 2) % 3;
  return below.high[axis] == above.low[axis] && below.low[a] < above.high[a] &&
    above.low[a] < below.high[a] && below.low[b] < above.high[b] && above.low[b] < below.high[b];
}

// The largest difference of the levels of two boxes that share part of a side. It knows positions
// only, not which boxes balancing takes for neighbours.
int largestDifference(const Boxes& boxes)
{
  int result = 0;
  for (std::size_t axis = 0; axis < 3; ++axis)
  {
    std::multimap<Level, Box> byLow;
    for (std::size_t b = 0; b < boxes.packed.size(); ++b)
    {
      const Box box = boxes.box(b);
      byLow.emplace(box.low[axis], box);
    }
    for (const auto& [low, box] : byLow)
    {
      const auto [first, end] = byLow.equal_range(box.high[axis]);
      for (auto other = first; other != end; ++other)
      {
        for (std::size_t along = 0; along < 3 && shareASide(box, other->second, axis); ++along)
        {
          result = std::max(result, std::abs(box.level[along] - other->second.level[along]));
        }
      }
    }
  }
  return result;
}

class FinalLevels : public LevelsAround
{
public:
  explicit FinalLevels(const Boxes& boxes)
    : boxes_(boxes)
  {
  }

  const std::array<std::uint8_t, 3>* at(const FinePoint& fine, std::int64_t& size) const override
  {
    const std::uint32_t box = boxes_.boxAt(fine, 0, size);
    return box == None ? nullptr : &boxes_.packed[box].level;
  }

private:
  const Boxes& boxes_;
};

// Whether no pass would halve a box any further.
bool isFinished(const Boxes& boxes)
{
  const FinalLevels levels(boxes);
  return std::all_of(boxes.packed.begin(), boxes.packed.end(), [&](const PackedBox& box) {
    bool finished = true;
    for (int level = 0; level <= DeepestLevel; ++level)
    {
      finished =
        finished && axesToHalve(levels, { boxes.fineLow(box), box.level }, balanceOf(level)) == 0;
    }
    return finished;
  });
}

// Of the levels of a box.
int mostLevelsApart(const Boxes& boxes)
{
  int result = 0;
  for (const PackedBox& box : boxes.packed)
  {
    const auto [least, most] = std::minmax({ box.level[0], box.level[1], box.level[2] });
    result = std::max(result, most - least);
  }
  return result;
}

int deepestOf(const Boxes& boxes)
{
  int result = 0;
  for (const PackedBox& box : boxes.packed)
  {
    result = std::max({ result, int(box.level[0]), int(box.level[1]), int(box.level[2]) });
  }
  return result;
}

// Boxes of a surface; meshlines are uneven, so that global boxes are longer in some directions.
class Boxing
{
public:
  Boxing(const Soup& soup, const GridSpec& grid, const RefinementSpec& refinement)
    : prepared_(prepare(soup, grid))
  {
    options_ = asTheyAre(0, refinement);
    decomposition_ = decompose(prepared_, options_, execution_);
  }

  SlabRange all() const { return decomposition_->allLayers(); }
  Boxes boxes() { return boxes(all()); }
  Boxes boxes(SlabRange core, int threads = 1)
  {
    Execution execution(threads);
    return decomposition_->boxes(core, execution);
  }

private:
  Execution execution_;
  TestOptions options_;
  PreparedSurface prepared_;
  std::unique_ptr<Decomposition> decomposition_;
};

GridSpec unevenGrid()
{
  GridSpec grid = cellsOf(1);
  grid.meshlines = { { { -1.3, -0.7, 0.11, 0.4, 1.3 }, { -1.3, -0.33, 0.21, 1.3 },
    { -1.3, -0.9, -0.54, -0.22, 0.17, 0.48, 0.79, 1.3 } } };
  return grid;
}

// What a random specification refers to.
struct RandomSpec
{
  std::vector<Soup> regions;
  RefinementSpec spec;
};

RandomSpec randomSpec(std::mt19937& random)
{
  const auto below = [&](int n) { return static_cast<int>(random() % static_cast<unsigned>(n)); };
  const std::array<int, 3> globals = { 4, 3, 7 };
  RandomSpec result;
  result.spec.depth = below(3);
  for (int n = below(3); n > 0; --n)
  {
    RefinementBlock block;
    for (std::size_t axis = 0; axis < 3; ++axis)
    {
      block.first[axis] = block.last[axis] = below(globals[axis]);
    }
    block.last[2] += below(3);
    block.forced = below(5);
    block.allowed = below(5);
    result.spec.blocks.push_back(block);
  }
  for (int n = below(3); n > 0; --n)
  {
    const auto extent = [&] { return 0.05 + 0.1 * below(10); };
    const Vector at = { 0.2 * below(6) - 0.5, 0.2 * below(6) - 0.5, 0.2 * below(6) - 0.5 };
    const Soup shape = below(2) == 0 ? sphere(3, extent())
                                     : box({ 0, 0, 0 }, { extent(), extent(), extent() }).turned();
    result.regions.push_back(shape.moved(at));
  }
  for (const Soup& region : result.regions)
  {
    result.spec.regions.push_back({ region.view(), below(5) });
  }
  return result;
}

TEST(Balance, HoldsInEachDirectionForAnyRefinement)
{
  std::mt19937 random(7);
  int deepest = 0;
  for (unsigned n = 0; n < repeats(60); ++n)
  {
    SCOPED_TRACE("case " + std::to_string(n));
    const Soup soup =
      n % 2 == 0 ? bumpySphere(n, 6) : box({ -1, -0.9, -1.1 }, { 1, 1, 1.2 }).turned();
    const RandomSpec refinement = randomSpec(random);
    const Boxes boxes = Boxing(soup, unevenGrid(), refinement.spec).boxes();
    EXPECT_LE(largestDifference(boxes), 1);
    EXPECT_LE(mostLevelsApart(boxes), MostLevelsApart);
    EXPECT_TRUE(isFinished(boxes));
    deepest = std::max(deepest, deepestOf(boxes));
  }
  EXPECT_EQ(deepest, 4);
}

TEST(Balance, HoldsForIsotropicBoxesToo)
{
  std::mt19937 random(13);
  for (unsigned n = 0; n < repeats(20); ++n)
  {
    SCOPED_TRACE("case " + std::to_string(n));
    RandomSpec refinement = randomSpec(random);
    refinement.spec.isotropic = true;
    refinement.spec.transitionLayers = static_cast<int>(n % 3);
    const Boxes boxes = Boxing(bumpySphere(n, 6), unevenGrid(), refinement.spec).boxes();
    EXPECT_LE(largestDifference(boxes), 1);
    EXPECT_EQ(mostLevelsApart(boxes), 0);
    EXPECT_TRUE(isFinished(boxes));
  }
}

TEST(Balance, IsTheSameForAnyNumberOfThreads)
{
  std::mt19937 random(11);
  for (unsigned n = 0; n < repeats(12); ++n)
  {
    SCOPED_TRACE("case " + std::to_string(n));
    const RandomSpec refinement = randomSpec(random);
    Boxing boxing(bumpySphere(n, 6), unevenGrid(), refinement.spec);
    const std::vector<Placed> whole = allPlaced(boxing.boxes());
    EXPECT_TRUE(whole == allPlaced(boxing.boxes(boxing.all(), 3)));
  }
}

// It is 20 boxes high: parts at one end do not see the other end.
Boxing towerOf(const RefinementSpec& refinement)
{
  GridSpec grid = cellsOf(1);
  grid.meshlines[0] = grid.meshlines[1] = { -0.9, 0.1, 1.1 };
  return { box({ 0, 0, 0 }, { 1, 1, 20 }), grid, refinement };
}

int depthOfLayer(const Boxes& boxes, std::uint32_t k)
{
  int result = 0;
  for (const PackedBox& box : boxes.packed)
  {
    result =
      std::max<int>(result, boxes.globalOf(box).index[2] == k ? boxes.globalOf(box).depth : 0);
  }
  return result;
}

// The layers of each part and its halo are those of the whole.
void expectPartsAgree(const RefinementSpec& refinement, const Boxes& whole)
{
  Boxing boxing = towerOf(refinement);
  for (std::uint32_t k = boxing.all().begin; k < boxing.all().end; ++k)
  {
    const Boxes part = boxing.boxes({ k, k + 1 });
    const auto layer = part.globalOf(part.packed[0]).index[2];
    const std::uint32_t first = whole.firstBoxOf(layer);
    ASSERT_LE(first + part.packed.size(), whole.packed.size());
    for (std::size_t b = 0; b < part.packed.size(); ++b)
    {
      ASSERT_TRUE(placed(part, b) == placed(whole, first + b)) << k << ", " << b;
    }
  }
}

// Around this tiny region at the wall, boxes are short across one axis and long along another.
TEST(Balance, ReachesAsFarAsPartsExpectIt)
{
  for (const bool upward : { false, true })
  {
    const std::uint32_t layer = upward ? 3 : 16;
    const Soup ball = sphere(1, 0.002).moved({ 0.46, 0, layer + (upward ? 0.964 : 0.036) });
    RefinementSpec spec;
    spec.regions.push_back({ ball.view(), DeepestLevel });
    const Boxes whole = towerOf(spec).boxes();
    EXPECT_LE(largestDifference(whole), 1);
    EXPECT_EQ(depthOfLayer(whole, layer), DeepestLevel);
    const std::uint32_t beyond = balanceReach(DeepestLevel, 1) + 1;
    EXPECT_EQ(depthOfLayer(whole, upward ? layer + beyond : layer - beyond), 0);
    expectPartsAgree(spec, whole);
  }
}

// Between what is finer than a level and what is coarser.
int fewestLayers(const Boxes& boxes, int level, std::size_t along)
{
  std::vector<Box> left;
  std::vector<Box> reached;
  for (std::size_t b = 0; b < boxes.packed.size(); ++b)
  {
    const Box box = boxes.box(b);
    (box.level[along] > level ? reached : left).push_back(box);
  }
  const auto touch = [](const Box& a, const Box& b) {
    bool any = false;
    for (std::size_t axis = 0; axis < 3; ++axis)
    {
      any = any || shareASide(a, b, axis) || shareASide(b, a, axis);
    }
    return any;
  };
  for (int layer = 0; !reached.empty(); ++layer)
  {
    std::vector<Box> next;
    std::vector<Box> others;
    for (const Box& box : left)
    {
      const bool isNext = std::any_of(
        reached.begin(), reached.end(), [&](const Box& other) { return touch(box, other); });
      (isNext ? next : others).push_back(box);
    }
    if (std::any_of(
          next.begin(), next.end(), [&](const Box& box) { return box.level[along] < level; }))
    {
      return layer;
    }
    left.swap(others);
    reached.swap(next);
  }
  return std::numeric_limits<int>::max(); // none is coarser
}

TEST(Balance, TransitionLayersAreBetweenLevels)
{
  std::mt19937 random(3);
  bool isAnyWithFew = false;
  for (unsigned n = 0; n < repeats(3); ++n)
  {
    SCOPED_TRACE("case " + std::to_string(n));
    RandomSpec refinement = randomSpec(random);
    for (const int layers : { 1, 2, 4 })
    {
      refinement.spec.transitionLayers = layers;
      const Boxes boxes = Boxing(bumpySphere(n, 6), unevenGrid(), refinement.spec).boxes();
      EXPECT_LE(largestDifference(boxes), 1);
      EXPECT_TRUE(isFinished(boxes));
      for (int level = 1; level < deepestOf(boxes); ++level)
      {
        for (const std::size_t along : { 0u, 1u, 2u })
        {
          const int fewest = fewestLayers(boxes, level, along);
          EXPECT_GE(fewest, layers) << "level " << level << ", axis " << along;
          isAnyWithFew = isAnyWithFew || (layers == 1 && fewest == 1);
        }
      }
    }
  }
  EXPECT_TRUE(isAnyWithFew);
}

TEST(Balance, TransitionLayersAreTheSameInParts)
{
  for (const bool upward : { false, true })
  {
    const Soup ball = sphere(1, 0.002).moved({ 0.46, 0, upward ? 9.964 : 10.036 });
    RefinementSpec spec;
    spec.transitionLayers = 3;
    spec.regions.push_back({ ball.view(), 3 });
    expectPartsAgree(spec, towerOf(spec).boxes());
  }
}

// Forced boxes are cubes: whatever is long after that, balance has made so.
TEST(Balance, AxesMayBePermuted)
{
  std::mt19937 random(5);
  for (unsigned n = 0; n < repeats(20); ++n)
  {
    RefinementSpec spec;
    for (int i = 0; i < 3; ++i)
    {
      const auto at = [&] { return static_cast<std::int64_t>(random() % 5); };
      RefinementBlock block{ { at(), at(), at() }, {}, 0, static_cast<int>(1 + random() % 5) };
      block.last = block.first;
      spec.blocks.push_back(block);
    }
    std::vector<std::vector<std::pair<Point, Levels>>> found;
    for (const std::array<int, 3>& axes :
      std::vector<std::array<int, 3>>{ { 0, 1, 2 }, { 1, 2, 0 }, { 2, 0, 1 }, { 1, 0, 2 } })
    {
      RefinementSpec permuted = spec;
      for (std::size_t b = 0; b < spec.blocks.size(); ++b)
      {
        for (std::size_t axis = 0; axis < 3; ++axis)
        {
          const auto old = static_cast<std::size_t>(axes[axis]);
          permuted.blocks[b].first[axis] = permuted.blocks[b].last[axis] =
            spec.blocks[b].first[old];
        }
      }
      const Boxes boxes = Boxing(cube(), cellsOf(0.2), permuted).boxes();
      found.emplace_back();
      for (std::size_t b = 0; b < boxes.packed.size(); ++b)
      {
        const Box box = boxes.box(b);
        std::pair<Point, Levels> original;
        for (std::size_t axis = 0; axis < 3; ++axis)
        {
          original.first[static_cast<std::size_t>(axes[axis])] = box.low[axis];
          original.second[static_cast<std::size_t>(axes[axis])] = box.level[axis];
        }
        found.back().push_back(original);
      }
      std::sort(found.back().begin(), found.back().end());
      EXPECT_TRUE(found.back() == found.front()) << "case " << n;
    }
  }
}

// Figure 2, across a side: boxes before a wall of fine ones shrink towards it, wherever it is, and
// none is halved along the wall that does not touch finer ones.
TEST(Balance, HalvesTowardsAWallFirst)
{
  for (std::size_t axis = 0; axis < 3; ++axis)
  {
    RefinementSpec spec;
    RefinementBlock block{ { 0, 0, 0 }, { 2, 2, 2 }, 0, 3 };
    block.last[axis] = 0;
    spec.blocks.push_back(block);
    const Boxes boxes = Boxing(cube(), cellsOf(1. / 3), spec).boxes();
    std::map<std::array<std::int64_t, 2>, int>
      count; // by the position, in 1/64, and level along the axis
    for (const PackedBox& box : boxes.packed)
    {
      ++count[{ boxes.fineLow(box)[axis] / (FinePerBox / 64), box.level[axis] }];
    }
    const std::map<std::array<std::int64_t, 2>, int> expected = { { { 0, 3 }, 576 },
      { { 8, 3 }, 576 }, { { 16, 3 }, 576 }, { { 24, 3 }, 576 }, { { 32, 3 }, 576 },
      { { 40, 3 }, 576 }, { { 48, 3 }, 576 }, { { 56, 3 }, 576 }, { { 64, 2 }, 144 },
      { { 80, 2 }, 36 }, { { 96, 1 }, 9 }, { { 128, 0 }, 9 } };
    EXPECT_EQ(count, expected) << "axis " << axis;
  }
}

}
}
