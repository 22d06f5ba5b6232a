// SPDX-License-Identifier: BSD-3-Clause
#include "Faces/ChordSimplification.h"

#include <gtest/gtest.h>

using namespace cartesian;

namespace
{

constexpr Level Width = 1000;

// A side of the plane z = 0; nodes are indices into `places`.
std::vector<SideEdge> simplified(const std::vector<Point>& places, std::vector<SideEdge> chords)
{
  Rectangle side{};
  side.axis = 2;
  side.low = { 0, 0 };
  side.high = { Width, Width };
  ChordSimplifier().simplify([&](std::uint32_t node) { return places[node]; }, side, chords);
  return chords;
}

std::vector<SideEdge> chainOf(std::uint32_t nodes)
{
  std::vector<SideEdge> chords;
  for (std::uint32_t i = 0; i + 1 < nodes; ++i)
  {
    chords.push_back({ i, i + 1 });
  }
  return chords;
}

}

TEST(ChordSimplification, NodesNearTheStraightLineGo)
{
  // From border to border, 10 levels aside where 100 are allowed.
  const std::vector<Point> places{ { 0, 500, 0 }, { 251, 509, 0 }, { 501, 491, 0 }, { 751, 509, 0 },
    { Width, 500, 0 } };
  const std::vector<SideEdge> left = simplified(places, chainOf(5));
  ASSERT_EQ(left.size(), 1U);
  EXPECT_EQ(left[0].from, 0U);
  EXPECT_EQ(left[0].to, 4U);
}

TEST(ChordSimplification, CornersStay)
{
  const std::vector<Point> places{ { 0, 101, 0 }, { 251, 103, 0 }, { 501, 701, 0 }, { 751, 103, 0 },
    { Width, 101, 0 } };
  EXPECT_EQ(simplified(places, chainOf(5)).size(), 4U);
}

TEST(ChordSimplification, NoChordComesToLieOnTheBorder)
{
  const std::vector<Point> places{ { 101, 0, 0 }, { 301, 21, 0 }, { 501, 0, 0 } };
  EXPECT_EQ(simplified(places, chainOf(3)).size(), 2U);
}

TEST(ChordSimplification, NarrowLoopsGoAndWideOnesStay)
{
  std::vector<SideEdge> loop = chainOf(4);
  loop.push_back({ 3, 0 });
  const std::vector<Point> narrow{ { 401, 401, 0 }, { 501, 401, 0 }, { 501, 501, 0 },
    { 401, 501, 0 } };
  EXPECT_TRUE(simplified(narrow, loop).empty());
  const std::vector<Point> wide{ { 201, 201, 0 }, { 801, 201, 0 }, { 801, 801, 0 },
    { 201, 801, 0 } };
  EXPECT_EQ(simplified(wide, loop).size(), 4U);
}

TEST(ChordSimplification, WhatWouldCrossStaysAsItIs)
{
  // Without its node aside, the first polyline would run through the small bend of the second.
  const std::vector<Point> places{ { 0, 500, 0 }, { 501, 541, 0 }, { Width, 500, 0 },
    { Width, 400, 0 }, { 601, 401, 0 }, { 501, 531, 0 }, { 401, 401, 0 }, { 0, 400, 0 } };
  std::vector<SideEdge> chords{ { 0, 1 }, { 1, 2 }, { 3, 4 }, { 4, 5 }, { 5, 6 }, { 6, 7 } };
  EXPECT_EQ(simplified(places, chords).size(), 6U);
}
