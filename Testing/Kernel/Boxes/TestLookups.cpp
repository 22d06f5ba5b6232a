// What is looked up often, against the plain way.
#include "Base/EdgeTable.h"
#include "Boxes/Boxes.h"
#include "Lattice/PointSortKey.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <map>
#include <random>
#include <tuple>

using namespace cartesian;

TEST(Lookups, EdgeTableIsEmptyAfterEachReset)
{
  std::mt19937 random(7);
  EdgeTable table;
  for (int use = 0; use < 500; ++use)
  {
    const auto edges = static_cast<std::uint32_t>(random() % 200);
    table.reset(edges);
    std::map<std::tuple<std::uint32_t, std::uint32_t, std::uint32_t>, std::uint32_t> plain;
    for (std::uint32_t i = 0; i < edges; ++i)
    {
      const auto lower = static_cast<std::uint32_t>(random() % 20);
      const auto upper = static_cast<std::uint32_t>(lower + 1 + random() % 20);
      const auto side = static_cast<std::uint32_t>(random() % 2);
      const auto [at, isNew] = plain.emplace(std::make_tuple(lower, upper, side), i);
      std::uint32_t& number = table.at(lower, upper, side);
      ASSERT_EQ(number, isNew ? EdgeTable::Fresh : at->second);
      number = at->second;
    }
  }
}

TEST(Lookups, NumberedPointsAreInOrderOfPlacesThenNumbers)
{
  std::mt19937 random(11);
  const auto level = [&] {
    return static_cast<Level>(random() % 3 == 0 ? random() : random() % 3);
  };
  std::vector<std::pair<Point, std::uint32_t>> plain;
  std::vector<PointSortKey> packed;
  for (int i = 0; i < 3000; ++i)
  {
    plain.push_back({ { level(), level(), level() }, level() });
    packed.emplace_back(plain.back().first, plain.back().second);
  }
  std::sort(plain.begin(), plain.end());
  std::sort(packed.begin(), packed.end());
  for (std::size_t i = 0; i < plain.size(); ++i)
  {
    EXPECT_EQ(packed[i].point(), plain[i].first);
    EXPECT_EQ(packed[i].number(), plain[i].second);
    EXPECT_TRUE(i == 0 || packed[i].isAt(packed[i - 1]) == (plain[i].first == plain[i - 1].first));
  }
}

// Rows with and without gaps, empty ones among them.
TEST(Lookups, GlobalBoxesAreFoundWhereverRowsHaveGaps)
{
  std::mt19937 random(13);
  constexpr std::uint32_t Size = 12;
  for (int trial = 0; trial < 50; ++trial)
  {
    Boxes boxes;
    for (auto& lines : boxes.planes)
    {
      lines.assign(Size + 1, 0);
    }
    const unsigned one = 1 + static_cast<unsigned>(trial) % 5;
    std::map<std::array<std::uint32_t, 3>, std::uint32_t> plain;
    for (std::uint32_t row = 0; row < Size * Size; ++row)
    {
      boxes.rowStart.push_back(boxes.globals.size());
      for (std::uint32_t i = 0; i < Size; ++i)
      {
        if (random() % one == 0 && row % 7 != 3)
        {
          const std::array<std::uint32_t, 3> at{ i, row % Size, row / Size };
          plain[at] = static_cast<std::uint32_t>(boxes.globals.size());
          boxes.globals.push_back({ at, 0, None, 0, 0 });
        }
      }
    }
    boxes.rowStart.push_back(boxes.globals.size());
    for (std::int64_t k = -1; k <= Size; ++k)
    {
      for (std::int64_t j = -1; j <= Size; ++j)
      {
        for (std::int64_t i = -1; i <= Size; ++i)
        {
          const auto found = plain.find({ static_cast<std::uint32_t>(i),
            static_cast<std::uint32_t>(j), static_cast<std::uint32_t>(k) });
          ASSERT_EQ(boxes.globalAt(i, j, k), found == plain.end() ? None : found->second);
        }
      }
    }
  }
}
