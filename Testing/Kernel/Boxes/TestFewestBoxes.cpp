// The search for the fewest boxes, against one that tries every sequence of splits.
#include "Boxes/FewestBoxes.h"

#include <gtest/gtest.h>

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

class BruteForce
{
public:
  BruteForce(int depth, int forced, const std::vector<BoxStatus>& units)
    : side_(1 << depth)
    , widest_(side_ >> forced)
    , units_(units)
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
    if (units == 1 || (inside == units && std::max({ size[0], size[1], size[2] }) <= widest_))
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
    for (int z = r.low[2]; z < r.high[2]; ++z)
    {
      for (int y = r.low[1]; y < r.high[1]; ++y)
      {
        for (int x = r.low[0]; x < r.high[0]; ++x)
        {
          found += units_[static_cast<std::size_t>(x + side_ * (y + side_ * z))] == status;
        }
      }
    }
    return found;
  }

  int side_;
  int widest_;
  const std::vector<BoxStatus>& units_;
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

// Each unit that is not outside lies in exactly one box, which has the status of all its units.
void expectCover(
  const std::vector<LocalBox>& boxes, int depth, int forced, const std::vector<BoxStatus>& units)
{
  const std::size_t side = std::size_t(1) << depth;
  const int unit = static_cast<int>(FinePerBox >> depth);
  std::vector<int> covered(units.size());
  for (const LocalBox& box : boxes)
  {
    std::array<std::size_t, 3> low;
    std::array<std::size_t, 3> size;
    for (std::size_t axis = 0; axis < 3; ++axis)
    {
      ASSERT_EQ(box.offset[axis] % (FinePerBox >> box.level[axis]), 0);
      ASSERT_GE(box.level[axis], forced);
      low[axis] = static_cast<std::size_t>(box.offset[axis] / unit);
      size[axis] = static_cast<std::size_t>((FinePerBox >> box.level[axis]) / unit);
    }
    for (std::size_t z = low[2]; z < low[2] + size[2]; ++z)
    {
      for (std::size_t y = low[1]; y < low[1] + size[1]; ++y)
      {
        for (std::size_t x = low[0]; x < low[0] + size[0]; ++x)
        {
          const std::size_t u = x + side * (y + side * z);
          ++covered[u];
          ASSERT_EQ(units[u], box.status);
        }
      }
    }
    if (box.status == BoxStatus::Intersected)
    {
      ASSERT_EQ(size, (std::array<std::size_t, 3>{ 1, 1, 1 }));
    }
  }
  for (std::size_t u = 0; u < units.size(); ++u)
  {
    ASSERT_EQ(covered[u], units[u] == BoxStatus::Outside ? 0 : 1);
  }
}

TEST(FewestBoxes, AreAsFewAsBruteForceFinds)
{
  std::mt19937 random(1);
  FewestBoxes search;
  for (int n = 0; n < 150; ++n)
  {
    const int depth = 1 + n % 2;
    const int forced = static_cast<int>(random() % static_cast<unsigned>(depth + 1));
    const std::vector<BoxStatus> units = randomUnits(depth, random);
    const std::uint32_t found = search.search(depth, forced, units);
    ASSERT_EQ(found, BruteForce(depth, forced, units).fewest()) << "case " << n;
    std::vector<LocalBox> boxes;
    search.collect(boxes);
    ASSERT_EQ(boxes.size(), found);
    expectCover(boxes, depth, forced, units);
  }
}

TEST(FewestBoxes, CoverDeepBoxesExactly)
{
  std::mt19937 random(2);
  FewestBoxes search;
  for (int depth = 3; depth <= 5; ++depth)
  {
    const std::vector<BoxStatus> units = randomUnits(depth, random);
    std::vector<LocalBox> boxes;
    ASSERT_GT(search.search(depth, 1, units), 0u);
    search.collect(boxes);
    expectCover(boxes, depth, 1, units);
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
  ASSERT_EQ(search.search(1, 0, units), 1u);
  std::vector<LocalBox> boxes;
  search.collect(boxes);
  EXPECT_EQ(boxes[0].level, (std::array<std::uint8_t, 3>{ 1, 0, 0 }));
}

}
}
