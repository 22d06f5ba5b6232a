// Equal points get equal numbers, no matter who uses them.
#include "Lattice/Numbering.h"

#include <gtest/gtest.h>

#include <map>
#include <random>
#include <set>

using namespace cartesian;

namespace
{

Point randomPoint(std::mt19937& random)
{
  return { static_cast<Level>(random() % 5), static_cast<Level>(random() % 5),
    static_cast<Level>(random() % 5) };
}

constexpr std::uint32_t Rows = 7;

// 1000 uses of few points, in chunks; each point belongs to one row.
std::vector<std::vector<PointUse>> questions(std::vector<Point>& asked)
{
  std::mt19937 random(1);
  std::vector<std::vector<PointUse>> uses(5);
  for (std::uint32_t slot = 0; slot < 1000; ++slot)
  {
    asked.push_back(randomPoint(random));
    uses[random() % 5].push_back({ asked.back(), asked.back()[2] + asked.back()[1] % 2, slot });
  }
  return uses;
}

}

TEST(Numbering, IsSortingByRowsAndPoints)
{
  std::vector<Point> asked;
  auto uses = questions(asked);
  Execution execution;
  const Numbering numbering = numberPoints(uses, Rows, execution);
  EXPECT_EQ(std::set<Point>(numbering.points.begin(), numbering.points.end()).size(),
    numbering.points.size());
  EXPECT_EQ(numbering.points.size(), std::set<Point>(asked.begin(), asked.end()).size());
  ASSERT_EQ(numbering.ofSlot.size(), asked.size());
  for (std::size_t slot = 0; slot < asked.size(); ++slot)
  {
    EXPECT_EQ(numbering.points[numbering.ofSlot[slot]], asked[slot]);
  }
  ASSERT_EQ(numbering.rowStart.size(), Rows + 1);
  EXPECT_EQ(numbering.rowStart.back(), numbering.points.size());
  for (std::size_t row = 0; row < Rows; ++row)
  {
    const auto begin = numbering.points.begin() + std::ptrdiff_t(numbering.rowStart[row]);
    const auto end = numbering.points.begin() + std::ptrdiff_t(numbering.rowStart[row + 1]);
    EXPECT_TRUE(std::is_sorted(begin, end));
    for (auto p = begin; p != end; ++p)
    {
      EXPECT_EQ((*p)[2] + (*p)[1] % 2, row);
    }
  }
}

TEST(Numbering, DependsOnNoThreads)
{
  std::vector<Point> asked;
  const auto uses = questions(asked);
  std::set<std::vector<Point>> results;
  for (const int threads : { 1, 2, 3, 8 })
  {
    Execution execution(threads);
    auto copy = uses;
    results.insert(numberPoints(copy, Rows, execution).points);
  }
  EXPECT_EQ(results.size(), 1U);
}

TEST(Numbering, OfNothing)
{
  std::vector<std::vector<PointUse>> none(3);
  Execution execution;
  EXPECT_TRUE(numberPoints(none, Rows, execution).points.empty());
}

TEST(LocalPoints, AreNumberedAsTheyCome)
{
  std::mt19937 random(1);
  LocalPoints points;
  for (int round = 0; round < 20; ++round)
  {
    points.clear();
    std::map<Point, std::uint32_t> expected;
    for (int i = 0; i < 100 * round; ++i)
    {
      Point p = randomPoint(random);
      p[0] += static_cast<Level>(i % 37 * 1000003); // enough for the table to grow
      const auto id = static_cast<std::uint32_t>(expected.size());
      const auto [at, fresh] = expected.emplace(p, id);
      EXPECT_EQ(points.add(p), at->second) << fresh;
    }
    EXPECT_EQ(points.points().size(), expected.size());
  }
}

TEST(Sorting, ScanTurnsCountsIntoStarts)
{
  std::vector<int> counts = { 3, 0, 2, 5, 0 };
  EXPECT_EQ(scan(counts), 10);
  EXPECT_EQ(counts, std::vector<int>({ 0, 3, 3, 5, 10 }));
}
