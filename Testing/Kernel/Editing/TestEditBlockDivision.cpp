// Blocks of boxes: who looks at what, what is free then, and what comes first.
#include "Editing/EditBlockDivision.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <map>
#include <set>

namespace cartesian
{

namespace
{

// A plate of boxes, all of one level, from (x, y, 0) on.
struct Plate
{
  std::uint32_t x, y, width, height;

  std::size_t size() const { return std::size_t(width) * height; }
  std::uint32_t number(std::uint32_t i, std::uint32_t j) const { return j * width + i; }

  std::vector<BoxPlace> places() const
  {
    std::vector<BoxPlace> all;
    for (std::uint32_t b = 0; b < size(); ++b)
    {
      all.push_back({ { x + b % width, y + b / width, 0 }, 3 });
    }
    return all;
  }

  void listBeside(std::uint32_t box, std::vector<std::uint32_t>& beside) const
  {
    const std::uint32_t i = box % width;
    const std::uint32_t j = box / width;
    for (std::uint32_t b = j == 0 ? 0 : j - 1; b < std::min(j + 2, height); ++b)
    {
      for (std::uint32_t a = i == 0 ? 0 : i - 1; a < std::min(i + 2, width); ++a)
      {
        beside.push_back(number(a, b));
      }
    }
  }

  std::uint32_t distance(std::uint32_t a, std::uint32_t b) const
  {
    const auto apart = [](std::uint32_t u, std::uint32_t v) { return u > v ? u - v : v - u; };
    return std::max(apart(a % width, b % width), apart(a / width, b / width));
  }
};

std::vector<AskedBox> askedOf(std::size_t count, std::uint32_t weight = 1)
{
  std::vector<AskedBox> all;
  for (std::uint32_t b = 0; b < count; ++b)
  {
    all.push_back({ b, weight });
  }
  return all;
}

EditBlockDivision divided(const Plate& plate, const std::vector<AskedBox>& asked,
  const EditBlockSize& size, int threads = 1)
{
  Execution execution(threads);
  return divideIntoEditBlocks(
    plate.places(), asked, size,
    [&](std::uint32_t box, Marks&, std::vector<std::uint32_t>& beside) {
      plate.listBeside(box, beside);
    },
    execution);
}

constexpr std::uint32_t Any = ~std::uint32_t(0);

}

TEST(EditBlockDivision, EachBoxIsOfOneBlockWithAllAroundItInItsZone)
{
  const Plate plate{ 3, 5, 41, 30 };
  for (const EditBlockSize& size : { EditBlockSize{ 8, 2, Any }, EditBlockSize{ 8, 4, Any },
         EditBlockSize{ 4, 4, Any }, EditBlockSize{ 8, 2, 9 } })
  {
    const EditBlockDivision division = divided(plate, askedOf(plate.size()), size);
    std::vector<int> times(plate.size());
    for (const EditBlock& block : division.blocks)
    {
      const std::set<std::uint32_t> zone(block.zone.begin(), block.zone.end());
      EXPECT_EQ(zone.size(), block.zone.size());
      for (std::uint32_t b = 0; b < plate.size(); ++b)
      {
        const bool isNear = std::any_of(block.own.begin(), block.own.end(),
          [&](std::uint32_t own) { return plate.distance(own, b) <= size.reach; });
        EXPECT_EQ(zone.count(b), isNear ? 1U : 0U);
      }
      for (const std::uint32_t b : block.own)
      {
        ++times[b];
      }
    }
    EXPECT_EQ(std::count(times.begin(), times.end(), 1), std::ptrdiff_t(plate.size()));
  }
}

TEST(EditBlockDivision, BlocksWaitForEarlierOnesWithBoxesOfTheirZone)
{
  const Plate plate{ 0, 0, 50, 50 };
  const EditBlockDivision division = divided(plate, askedOf(plate.size()), { 8, 4, Any });
  for (std::size_t b = 0; b < division.blocks.size(); ++b)
  {
    std::vector<std::uint32_t> expected;
    const auto& zone = division.blocks[b].zone;
    for (std::uint32_t other = 0; other < b; ++other)
    {
      const auto& others = division.blocks[other].zone;
      if (std::any_of(zone.begin(), zone.end(), [&](std::uint32_t box) {
            return std::find(others.begin(), others.end(), box) != others.end();
          }))
      {
        expected.push_back(other);
      }
    }
    EXPECT_EQ(division.after[b], expected);
  }
}

// As many steps one after the other as there are colours, however large the plate is.
TEST(EditBlockDivision, NoChainIsLongerThanThereAreColours)
{
  for (const auto& [size, colours] : std::map<std::uint32_t, std::size_t>{ { 4, 9 }, { 8, 4 } })
  {
    const Plate plate{ 1, 2, 100, 90 };
    const EditBlockDivision division = divided(plate, askedOf(plate.size()), { size, 4, Any });
    std::vector<std::size_t> steps(division.blocks.size(), 1);
    for (std::size_t b = 0; b < steps.size(); ++b)
    {
      for (const std::uint32_t earlier : division.after[b])
      {
        steps[b] = std::max(steps[b], steps[earlier] + 1);
      }
    }
    EXPECT_EQ(*std::max_element(steps.begin(), steps.end()), colours);
  }
}

TEST(EditBlockDivision, HeavyBlocksAreDividedAndComeLast)
{
  const Plate plate{ 0, 0, 32, 32 };
  std::vector<AskedBox> asked = askedOf(plate.size());
  asked[plate.number(9, 9)].weight = 100;
  const EditBlockDivision division = divided(plate, asked, { 8, 2, 100 });
  ASSERT_EQ(division.blocks.size(), 15U + 4);
  for (std::size_t b = 0; b < division.blocks.size(); ++b)
  {
    EXPECT_EQ(division.blocks[b].own.size(), b < 15 ? 64U : 16U);
  }
}

// Cut off elsewhere, the same blocks in the same order, wherever numbers begin.
TEST(EditBlockDivision, PlacesDecideAlone)
{
  const Plate whole{ 0, 0, 60, 20 };
  const Plate part{ 16, 0, 30, 20 };
  const EditBlockSize size{ 8, 2, Any };
  const auto named = [](const Plate& plate, const std::vector<std::uint32_t>& boxes) {
    std::set<std::pair<std::uint32_t, std::uint32_t>> places;
    for (const std::uint32_t b : boxes)
    {
      places.emplace(plate.x + b % plate.width, plate.y + b / plate.width);
    }
    return places;
  };
  const EditBlockDivision a = divided(whole, askedOf(whole.size()), size);
  const EditBlockDivision b = divided(part, askedOf(part.size()), size, 3);
  std::size_t next = 0;
  int found = 0;
  for (const EditBlock& block : b.blocks)
  {
    const auto own = named(part, block.own);
    if (own.begin()->first < 24 || own.rbegin()->first >= 38) // near the cut: zones differ
    {
      continue;
    }
    while (next < a.blocks.size() && named(whole, a.blocks[next].own) != own)
    {
      ++next;
    }
    ASSERT_LT(next, a.blocks.size());
    EXPECT_EQ(named(whole, a.blocks[next].zone), named(part, block.zone));
    ++found;
  }
  EXPECT_EQ(found, 3);
}

}
