// Sets that threads unite at the same time are those that one thread unites.
#include "Base/ConcurrentSets.h"
#include "Base/DisjointSets.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <random>

using namespace cartesian;

TEST(ConcurrentSets, AreTheSameOnThreads)
{
  constexpr std::size_t Numbers = 20000;
  std::mt19937 random(1);
  std::uniform_int_distribution<std::uint32_t> any(0, Numbers - 1);
  // From many small sets to one of nearly all.
  for (const std::size_t unions : { Numbers / 4, Numbers / 2, Numbers, 4 * Numbers })
  {
    std::vector<std::array<std::uint32_t, 2>> pairs(unions);
    std::generate(pairs.begin(), pairs.end(), [&] {
      return std::array<std::uint32_t, 2>{ any(random), any(random) };
    });
    DisjointSets expected(Numbers);
    for (const auto& [x, y] : pairs)
    {
      expected.unite(x, y);
    }
    Execution execution(8);
    ConcurrentSets sets(Numbers, execution);
    execution.forEach(unions, 16, [&](std::size_t begin, std::size_t end) {
      for (std::size_t i = begin; i < end; ++i)
      {
        sets.unite(pairs[i][0], pairs[i][1]);
      }
    });
    for (std::uint32_t x = 0; x < Numbers; ++x)
    {
      ASSERT_EQ(sets.find(x), expected.find(x)) << x << " after " << unions << " unions";
    }
  }
}
