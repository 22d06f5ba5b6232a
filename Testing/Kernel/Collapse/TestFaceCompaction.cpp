#include "Collapse/FaceCompaction.h"

#include <gtest/gtest.h>

#include <iterator>
#include <random>

using namespace cartesian;

// Against the plain way; more groups than a chunk has, empty ones among them.
TEST(FaceCompaction, LeavesTheFacesInTheirGroups)
{
  std::mt19937 random(5);
  for (const int threads : { 1, 3 })
  {
    std::vector<std::size_t> groupStart{ 0 };
    RawVector<std::size_t> start{ 0 };
    RawVector<std::uint32_t> corners;
    std::vector<std::size_t> number;
    std::vector<std::vector<std::vector<std::uint32_t>>> plain(10000);
    std::vector<std::size_t> plainNumber;
    for (auto& group : plain)
    {
      for (auto faces = random() % 4; faces > 0; --faces)
      {
        std::vector<std::uint32_t> left;
        for (auto size = 3 + random() % 4; size > 0; --size)
        {
          corners.push_back(static_cast<std::uint32_t>(random() % 100));
          if (corners.back() >= 20)
          {
            left.push_back(corners.back());
          }
        }
        number.push_back(start.size());
        start.push_back(corners.size());
        if (left.size() > 2)
        {
          group.push_back(left);
          plainNumber.push_back(number.back());
        }
      }
      groupStart.push_back(start.size() - 1);
    }
    Execution execution(threads);
    compactFaces(
      groupStart, start, corners,
      [](const std::uint32_t* begin, const std::uint32_t* end, std::vector<std::uint32_t>& ring) {
        ring.clear();
        std::copy_if(
          begin, end, std::back_inserter(ring), [](std::uint32_t corner) { return corner >= 20; });
      },
      [&](std::size_t from, std::size_t to) { number[to] = number[from]; }, execution);
    number.resize(start.size() - 1);
    EXPECT_EQ(number, plainNumber);
    ASSERT_EQ(groupStart.size(), plain.size() + 1);
    EXPECT_EQ(groupStart.back(), start.size() - 1);
    EXPECT_EQ(start.back(), corners.size());
    for (std::size_t g = 0; g < plain.size(); ++g)
    {
      ASSERT_EQ(groupStart[g + 1] - groupStart[g], plain[g].size());
      for (std::size_t f = 0; f < plain[g].size(); ++f)
      {
        const auto face = groupStart[g] + f;
        const std::vector<std::uint32_t> ring(corners.begin() + std::ptrdiff_t(start[face]),
          corners.begin() + std::ptrdiff_t(start[face + 1]));
        ASSERT_EQ(ring, plain[g][f]);
      }
    }
  }
}
