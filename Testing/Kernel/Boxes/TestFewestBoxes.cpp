// The search for the fewest boxes, against one that tries every sequence of splits.
#include "Boxes/FewestBoxes.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <random>

namespace cartesian
{
namespace
{

// Units [low, high) of a cube of `side` units.
struct Range
{
  std::array<int, 3> low;
  std::array<int, 3> high;
};

// What the search is asked for.
struct Case
{
  int depth;
  int allowed;
  std::vector<BoxStatus> units;
  std::vector<std::uint8_t> forced; // of each unit

  std::size_t unit(int x, int y, int z) const
  {
    return static_cast<std::size_t>(x | y << depth | z << 2 * depth);
  }
};

class BruteForce
{
public:
  explicit BruteForce(const Case& asked)
    : side_(1 << asked.depth)
    , asked_(asked)
  {
  }

  std::uint32_t fewest() const { return fewest({ { 0, 0, 0 }, { side_, side_, side_ } }); }

private:
  std::uint32_t fewest(const Range& r) const
  {
    const int inside = count(r, BoxStatus::Inside);
    const int intersected = count(r, BoxStatus::Intersected);
    const std::array<int, 3> size = { r.high[0] - r.low[0], r.high[1] - r.low[1],
      r.high[2] - r.low[2] };
    const int units = size[0] * size[1] * size[2];
    if (inside + intersected == 0)
    {
      return 0;
    }
    const int widest = std::max({ size[0], size[1], size[2] });
    const bool mayStay = intersected > 0 ? widest <= side_ >> asked_.allowed : inside == units;
    if (mayStay && widest <= side_ >> forced(r))
    {
      return 1;
    }
    std::uint32_t best = ~0u;
    for (std::size_t axis = 0; axis < 3; ++axis)
    {
      if (size[axis] > 1)
      {
        Range lower = r;
        Range upper = r;
        lower.high[axis] = upper.low[axis] = r.low[axis] + size[axis] / 2;
        best = std::min(best, fewest(lower) + fewest(upper));
      }
    }
    return best;
  }

  int count(const Range& r, BoxStatus status) const
  {
    int found = 0;
    forEachUnit(r, [&](std::size_t unit) { found += asked_.units[unit] == status; });
    return found;
  }

  int forced(const Range& r) const
  {
    int most = 0;
    forEachUnit(r, [&](std::size_t unit) { most = std::max(most, int(asked_.forced[unit])); });
    return most;
  }

  template <class Visitor>
  void forEachUnit(const Range& r, Visitor&& visit) const
  {
    for (int z = r.low[2]; z < r.high[2]; ++z)
    {
      for (int y = r.low[1]; y < r.high[1]; ++y)
      {
        for (int x = r.low[0]; x < r.high[0]; ++x)
        {
          visit(asked_.unit(x, y, z));
        }
      }
    }
  }

  int side_;
  const Case& asked_;
};

std::vector<BoxStatus> randomUnits(int depth, std::mt19937& random)
{
  // The share of each status varies from case to case, so that large boxes occur.
  const double outside = std::uniform_real_distribution<>(0, 1)(random);
  const double intersected = std::uniform_real_distribution<>(0, 0.3)(random);
  std::vector<BoxStatus> units(std::size_t(1) << 3 * depth);
  const bool halves = random() % 2 == 0; // outside units on one side only
  const auto side = std::size_t(1) << depth;
  for (std::size_t u = 0; u < units.size(); ++u)
  {
    const double draw = std::uniform_real_distribution<>(0, 1)(random);
    const auto column = static_cast<double>(u % side) / static_cast<double>(side);
    const bool out = halves ? column < outside : draw < outside;
    units[u] = out ? BoxStatus::Outside : BoxStatus::Inside;
    if (std::uniform_real_distribution<>(0, 1)(random) < intersected)
    {
      units[u] = BoxStatus::Intersected;
    }
  }
  return units;
}

// The same everywhere, or, as where a region's border passes, on one side of a plane only.
std::vector<std::uint8_t> randomForced(int depth, std::mt19937& random)
{
  const auto below = [&](int n) { return static_cast<int>(random() % static_cast<unsigned>(n)); };
  std::vector<std::uint8_t> forced(
    std::size_t(1) << 3 * depth, static_cast<std::uint8_t>(below(depth + 1)));
  const int axis = below(3);
  const int plane = below(1 << depth);
  for (std::size_t u = 0; u < forced.size() && below(2) == 0; ++u)
  {
    const int at = static_cast<int>(u >> axis * depth) & ((1 << depth) - 1);
    forced[u] = at < plane ? static_cast<std::uint8_t>(depth) : forced[u];
  }
  return forced;
}

Case randomCase(int depth, std::mt19937& random)
{
  const int allowed = static_cast<int>(random() % static_cast<unsigned>(depth + 1));
  return { depth, allowed, randomUnits(depth, random), randomForced(depth, random) };
}

// Each unit that is not outside lies in exactly one box, which is as small as all its units demand.
void expectCover(const std::vector<LocalBox>& boxes, const Case& asked)
{
  const int unit = static_cast<int>(FinePerBox >> asked.depth);
  std::vector<int> covered(asked.units.size());
  for (const LocalBox& box : boxes)
  {
    std::array<int, 3> low;
    std::array<int, 3> size;
    for (std::size_t axis = 0; axis < 3; ++axis)
    {
      ASSERT_EQ(box.offset[axis] % (FinePerBox >> box.level[axis]), 0);
      low[axis] = box.offset[axis] / unit;
      size[axis] = static_cast<int>(FinePerBox >> box.level[axis]) / unit;
    }
    const int least = std::min({ box.level[0], box.level[1], box.level[2] });
    ASSERT_GE(least, box.status == BoxStatus::Intersected ? asked.allowed : 0);
    bool intersected = false;
    for (int z = low[2]; z < low[2] + size[2]; ++z)
    {
      for (int y = low[1]; y < low[1] + size[1]; ++y)
      {
        for (int x = low[0]; x < low[0] + size[0]; ++x)
        {
          const std::size_t u = asked.unit(x, y, z);
          ++covered[u];
          ASSERT_GE(least, asked.forced[u]);
          intersected = intersected || asked.units[u] == BoxStatus::Intersected;
          ASSERT_TRUE(box.status == BoxStatus::Intersected || asked.units[u] == box.status);
        }
      }
    }
    ASSERT_EQ(intersected, box.status == BoxStatus::Intersected);
  }
  for (std::size_t u = 0; u < covered.size(); ++u)
  {
    // A box that is not halved further because it is intersected may hold outside units.
    ASSERT_LE(covered[u], 1);
    ASSERT_TRUE(covered[u] == 1 || asked.units[u] == BoxStatus::Outside);
  }
}

TEST(FewestBoxes, AreAsFewAsBruteForceFinds)
{
  std::mt19937 random(1);
  FewestBoxes search;
  for (int n = 0; n < 300; ++n)
  {
    const Case asked = randomCase(1 + n % 2, random);
    const std::uint32_t found =
      search.search(Cube{}, asked.depth, asked.allowed, asked.units, asked.forced);
    ASSERT_EQ(found, BruteForce(asked).fewest()) << "case " << n;
    std::vector<LocalBox> boxes;
    std::vector<std::uint32_t> toDivide;
    search.collect(boxes, toDivide);
    ASSERT_EQ(boxes.size(), found);
    ASSERT_TRUE(toDivide.empty());
    expectCover(boxes, asked);
  }
}

TEST(FewestBoxes, CoverDeepBoxesExactly)
{
  std::mt19937 random(2);
  FewestBoxes search;
  for (int depth = 3; depth <= 5; ++depth)
  {
    const Case asked = randomCase(depth, random);
    std::vector<LocalBox> boxes;
    std::vector<std::uint32_t> toDivide;
    ASSERT_GT(search.search(Cube{}, depth, asked.allowed, asked.units, asked.forced), 0u);
    search.collect(boxes, toDivide);
    ASSERT_TRUE(toDivide.empty());
    expectCover(boxes, asked);
  }
}

// Of a block in a global box, units that must be deeper than they are become blocks, each of its own.
TEST(FewestBoxes, LeaveDeeperUnitsToOtherBlocks)
{
  std::mt19937 random(3);
  FewestBoxes search;
  for (int n = 0; n < 100; ++n)
  {
    const Cube cube{ { FinePerBox / 2, 0, FinePerBox / 4 }, 2 };
    Case asked = randomCase(2, random);
    for (std::uint8_t& forced : asked.forced)
    {
      forced = static_cast<std::uint8_t>(forced + random() % 4);
    }
    const int allowed = static_cast<int>(2 + random() % 4);
    const std::uint32_t found = search.search(cube, 2, allowed, asked.units, asked.forced);
    std::vector<LocalBox> boxes;
    std::vector<std::uint32_t> toDivide;
    search.collect(boxes, toDivide);
    ASSERT_EQ(boxes.size() + toDivide.size(), found);
    std::vector<int> covered(asked.units.size());
    for (const std::uint32_t unit : toDivide)
    {
      ++covered[unit];
      ASSERT_NE(asked.units[unit], BoxStatus::Outside);
      ASSERT_TRUE(
        asked.forced[unit] > 4 || (allowed > 4 && asked.units[unit] == BoxStatus::Intersected));
    }
    for (const LocalBox& box : boxes)
    {
      const int least = std::min({ box.level[0], box.level[1], box.level[2] });
      const int most = std::max({ box.level[0], box.level[1], box.level[2] });
      ASSERT_TRUE(least >= 2 && most <= 4);
      for (std::size_t unit = 0; unit < covered.size(); ++unit)
      {
        const Offset at = cube.part(2, unit).offset;
        bool in = true;
        for (std::size_t axis = 0; axis < 3; ++axis)
        {
          in = in && at[axis] >= box.offset[axis] &&
            at[axis] < box.offset[axis] + (FinePerBox >> box.level[axis]);
        }
        covered[unit] += in ? 1 : 0;
        ASSERT_TRUE(!in || least >= asked.forced[unit]);
        ASSERT_TRUE(!in || asked.units[unit] != BoxStatus::Intersected || least >= allowed);
      }
    }
    for (std::size_t unit = 0; unit < covered.size(); ++unit)
    {
      ASSERT_LE(covered[unit], 1);
      ASSERT_TRUE(covered[unit] == 1 || asked.units[unit] == BoxStatus::Outside);
    }
  }
}

TEST(FewestBoxes, AreCubesIfTheyMustBeIsotropic)
{
  std::mt19937 random(4);
  FewestBoxes search(true);
  for (int n = 0; n < 100; ++n)
  {
    const Case asked = randomCase(1 + n % 3, random);
    const std::uint32_t found =
      search.search(Cube{}, asked.depth, asked.allowed, asked.units, asked.forced);
    std::vector<LocalBox> boxes;
    std::vector<std::uint32_t> toDivide;
    search.collect(boxes, toDivide);
    ASSERT_EQ(boxes.size(), found);
    expectCover(boxes, asked);
    for (const LocalBox& box : boxes)
    {
      ASSERT_TRUE(box.level[0] == box.level[1] && box.level[1] == box.level[2]);
    }
  }
}

TEST(FewestBoxes, SplitInOneDirectionOnly)
{
  // A wall across x: the half behind it is outside, the half before it one box.
  std::vector<BoxStatus> units(8);
  for (std::size_t u = 0; u < units.size(); ++u)
  {
    units[u] = u % 2 == 0 ? BoxStatus::Inside : BoxStatus::Outside;
  }
  FewestBoxes search;
  ASSERT_EQ(search.search(Cube{}, 1, 1, units, std::vector<std::uint8_t>(8, 0)), 1u);
  std::vector<LocalBox> boxes;
  std::vector<std::uint32_t> toDivide;
  search.collect(boxes, toDivide);
  EXPECT_EQ(boxes[0].level, (std::array<std::uint8_t, 3>{ 1, 0, 0 }));
}

}
}
