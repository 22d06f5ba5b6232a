// Disjoint sets, buckets and reused objects, against the plain way to do the same.
#include "Base/DisjointSets.h"
#include "Base/ObjectPool.h"
#include "Base/Sorting.h"

#include <gtest/gtest.h>

#include <random>

using namespace cartesian;

TEST(DisjointSets, AgreeWithRelabelling)
{
  std::mt19937 random(3);
  DisjointSets sets;
  for (std::size_t size = 1; size < 60; ++size)
  {
    sets.reset(size);
    std::vector<std::uint32_t> lowest(size); // of each number's set
    std::iota(lowest.begin(), lowest.end(), 0);
    for (std::size_t i = 0; i < size; ++i)
    {
      const auto x = static_cast<std::uint32_t>(random() % size);
      const auto y = static_cast<std::uint32_t>(random() % size);
      const std::uint32_t kept = std::min(lowest[x], lowest[y]);
      const std::uint32_t gone = std::max(lowest[x], lowest[y]);
      std::replace(lowest.begin(), lowest.end(), gone, kept);
      EXPECT_EQ(sets.unite(x, y), kept);
      for (std::uint32_t n = 0; n < size; ++n)
      {
        ASSERT_EQ(sets.find(n), lowest[n]);
      }
    }
  }
}

TEST(Buckets, AreSortedWhateverTheThreads)
{
  std::mt19937 random(5);
  constexpr std::size_t Count = 7;
  std::vector<std::vector<unsigned>> chunkItems(20);
  std::vector<std::vector<unsigned>> wanted(Count);
  for (auto& items : chunkItems)
  {
    for (std::size_t i = random() % 50; i > 0; --i)
    {
      items.push_back(static_cast<unsigned>(random() % 1000));
      wanted[items.back() % Count].push_back(items.back());
    }
  }
  for (int threads = 1; threads <= 3; ++threads)
  {
    Execution execution(threads);
    auto copy = chunkItems;
    const Buckets<unsigned> buckets = sortIntoBuckets(
      copy, Count, [](unsigned item) { return item % Count; }, execution);
    for (std::size_t b = 0; b < Count; ++b)
    {
      std::sort(wanted[b].begin(), wanted[b].end());
      EXPECT_EQ(std::vector<unsigned>(buckets.begin(b), buckets.end(b)), wanted[b]);
    }
    EXPECT_EQ(buckets.start.size(), Count + 1);
    EXPECT_EQ(buckets.items.size(), buckets.start.back());
    EXPECT_TRUE(copy.front().empty());
  }
}

TEST(Buckets, ScanGivesStartsAndTotal)
{
  std::vector<std::size_t> counts{ 3, 0, 2, 5 };
  EXPECT_EQ(scan(counts), 10u);
  EXPECT_EQ(counts, (std::vector<std::size_t>{ 0, 3, 3, 5 }));
}

TEST(ObjectPool, ReturnsReleasedStorage)
{
  ObjectPool<std::vector<int>> pool;
  EXPECT_TRUE(pool.acquire().empty());
  std::vector<std::vector<int>> used{ std::vector<int>(1000) };
  const int* const storage = used[0].data();
  pool.release(used);
  EXPECT_TRUE(used.empty());
  EXPECT_EQ(pool.acquire().data(), storage);
  EXPECT_TRUE(pool.acquire().empty());
}

// Of few and of many items, all different, of few values, or in order.
TEST(Sorting, AllThreadsSortAsOne)
{
  std::mt19937 random(5);
  for (const int threads : { 1, 3 })
  {
    Execution execution(threads);
    for (const std::size_t size : { 0U, 1U, 5000U, 100000U })
    {
      for (const std::uint32_t values : { 2U, 1000U, ~0U })
      {
        std::vector<std::uint32_t> items(size);
        std::generate(items.begin(), items.end(),
          [&] { return static_cast<std::uint32_t>(random() % values); });
        std::vector<std::uint32_t> expected = items;
        std::sort(expected.begin(), expected.end());
        for (int repeat = 0; repeat < 2; ++repeat)
        {
          sortAll(items, execution);
          EXPECT_EQ(items, expected);
        }
      }
    }
  }
}

// Of items in several buckets each, some of which are empty and one is large.
TEST(Sorting, BucketsAreSorted)
{
  constexpr std::size_t Things = 50000;
  constexpr std::size_t Number = 7;
  const auto visit = [](std::size_t begin, std::size_t end, auto&& add) {
    for (std::size_t i = begin; i < end; ++i)
    {
      add(3, i * 7919 % Things);
      if (i % 5 == 0)
      {
        add(6, i);
      }
    }
  };
  for (const int threads : { 1, 4 })
  {
    Execution execution(threads);
    const Buckets<std::size_t> buckets =
      fillBuckets<std::size_t>(Things, 100, Number, visit, execution);
    ASSERT_EQ(buckets.start.size(), Number + 1);
    for (std::size_t b = 0; b < Number; ++b)
    {
      const std::size_t size = b == 3 ? Things : (b == 6 ? Things / 5 : 0);
      ASSERT_EQ(buckets.end(b) - buckets.begin(b), static_cast<std::ptrdiff_t>(size));
      for (std::size_t i = 0; i < size; ++i)
      {
        ASSERT_EQ(buckets.begin(b)[i], b == 3 ? i : 5 * i);
      }
    }
  }
}
