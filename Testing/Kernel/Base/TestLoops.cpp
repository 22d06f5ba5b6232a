// Closed walks are separated into loops that visit no node twice.
#include "Base/Loops.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <map>
#include <random>
#include <set>

using namespace cartesian;

namespace
{

using Walk = std::vector<std::uint32_t>;

std::vector<Walk> loopsOf(Walk walk)
{
  std::vector<Walk> loops;
  forEachSimpleLoop(walk,
    [&](const std::uint32_t* begin, const std::uint32_t* end) { loops.emplace_back(begin, end); });
  return loops;
}

std::map<std::pair<std::uint32_t, std::uint32_t>, int> edgesOf(const std::vector<Walk>& walks)
{
  std::map<std::pair<std::uint32_t, std::uint32_t>, int> sums;
  for (const Walk& walk : walks)
  {
    for (std::size_t i = 0; i < walk.size(); ++i)
    {
      const std::uint32_t from = walk[i];
      const std::uint32_t to = walk[(i + 1) % walk.size()];
      if (from != to)
      {
        sums[std::minmax(from, to)] += from < to ? 1 : -1;
      }
    }
  }
  for (auto edge = sums.begin(); edge != sums.end();)
  {
    edge = edge->second == 0 ? sums.erase(edge) : std::next(edge);
  }
  return sums;
}

}

TEST(Loops, ASimpleLoopStays)
{
  EXPECT_EQ(loopsOf({ 3, 1, 4, 5 }), std::vector<Walk>({ { 3, 1, 4, 5 } }));
}

TEST(Loops, AnEightFallsInTwo)
{
  EXPECT_EQ(loopsOf({ 0, 1, 2, 0, 3, 4 }), std::vector<Walk>({ { 0, 1, 2 }, { 0, 3, 4 } }));
}

TEST(Loops, WhatRunsToAndFroVanishes)
{
  EXPECT_TRUE(loopsOf({ 0, 1 }).empty());
  EXPECT_TRUE(loopsOf({ 0, 1, 2, 1 }).empty());
  EXPECT_EQ(loopsOf({ 0, 1, 2, 5, 2 }), std::vector<Walk>({ { 0, 1, 2 } }));
  EXPECT_TRUE(loopsOf({ 7, 7, 7 }).empty());
  EXPECT_TRUE(loopsOf({}).empty());
}

TEST(Loops, RandomWalksKeepTheirEdges)
{
  std::mt19937 random(1);
  for (int i = 0; i < 500; ++i)
  {
    Walk walk(random() % 30);
    for (std::uint32_t& node : walk)
    {
      node = static_cast<std::uint32_t>(random() % 8);
    }
    const std::vector<Walk> loops = loopsOf(walk);
    for (const Walk& loop : loops)
    {
      EXPECT_GE(loop.size(), 3U);
      EXPECT_EQ(std::set<std::uint32_t>(loop.begin(), loop.end()).size(), loop.size());
    }
    EXPECT_EQ(edgesOf(loops), edgesOf({ walk }));
  }
}

// ... and are those that a search along the walk finds, however long it is.
TEST(Loops, LongWalksFallIntoTheSameLoops)
{
  std::mt19937 random(2);
  for (int i = 0; i < 50; ++i)
  {
    Walk walk(65 + random() % 500);
    for (std::uint32_t& node : walk)
    {
      node = static_cast<std::uint32_t>(random() % (i < 25 ? 30 : 3000));
    }
    std::vector<Walk> expected;
    Walk open;
    for (const std::uint32_t node : walk)
    {
      const auto before = std::find(open.begin(), open.end(), node);
      if (open.end() - before > 2)
      {
        expected.emplace_back(before, open.end());
      }
      open.erase(before, open.end());
      open.push_back(node);
    }
    if (open.size() > 2)
    {
      expected.push_back(open);
    }
    EXPECT_EQ(loopsOf(walk), expected);
  }
}
