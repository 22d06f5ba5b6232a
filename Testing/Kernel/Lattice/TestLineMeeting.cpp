// Where lines meet triangles.
#include "Lattice/LineMeeting.h"

#include <gtest/gtest.h>

#include <cmath>

using namespace cartesian;

namespace
{

// In the plane z = 8, with its normal along z.
const Corners Triangle{ Point{ 4, 0, 8 }, Point{ 20, 0, 8 }, Point{ 4, 32, 8 } };

}

TEST(LineMeeting, IsAtItsDistanceAndWeights)
{
  // Half of the way to the second corner, a quarter of the way to the third.
  const LineMeeting up = meetLine(Triangle, { 12, 8, -2 }, { 0, 0, 2 });
  EXPECT_EQ(up.distance, 5);
  EXPECT_EQ(up.second, 0.5);
  EXPECT_EQ(up.third, 0.25);
  EXPECT_TRUE(up.leaves);
  const LineMeeting down = meetLine(Triangle, { 12, 8, -2 }, { 0, 0, -2 });
  EXPECT_EQ(down.distance, -5);
  EXPECT_EQ(down.second, 0.5);
  EXPECT_EQ(down.third, 0.25);
  EXPECT_FALSE(down.leaves);
}

TEST(LineMeeting, OfASlantedLineIsWhereItPassesThePlane)
{
  const LineMeeting met = meetLine(Triangle, { 0, 0, 0 }, { 1, 2, 1 }); // at 8, 16, 8
  EXPECT_EQ(met.distance, 8);
  EXPECT_EQ(met.second, 0.25);
  EXPECT_EQ(met.third, 0.5);
}

TEST(LineMeeting, MayBeBesideTheTriangle)
{
  const LineMeeting met = meetLine(Triangle, { 28, -32, 0 }, { 0, 0, 1 });
  EXPECT_EQ(met.distance, 8);
  EXPECT_EQ(met.second, 1.5);
  EXPECT_EQ(met.third, -1);
}

TEST(LineMeeting, OfParallelLinesHasNoDistance)
{
  EXPECT_FALSE(std::isfinite(meetLine(Triangle, { 0, 0, 0 }, { 1, 0, 0 }).distance));
  EXPECT_FALSE(std::isfinite(meetLine(Triangle, { 4, 0, 8 }, { 1, 1, 0 }).distance));
}
