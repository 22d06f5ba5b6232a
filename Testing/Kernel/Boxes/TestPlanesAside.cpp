// SPDX-License-Identifier: BSD-3-Clause
#include "Boxes/PlanesAside.h"

#include "Support/Pipeline.h"

#include <gtest/gtest.h>

#include <cmath>

using namespace cartesian;

namespace
{

// The planes after they stepped aside from a box between the levels 11 and 101 along x and y, and those
// given along z.
Meshlines planesBeside(double low, double high, const std::vector<Level>& along, int depth = 0)
{
  const std::vector<Level> across{ 0, along.back() };
  const Meshlines given{ { across, across, along } };
  const PreparedSurface prepared = prepareOnLevels(box({ 11, 11, low }, { 101, 101, high }), given);
  Meshlines planes = given;
  Execution execution;
  stepAside(prepared.surface, depth, planes, execution);
  return planes;
}

Level meshlineBeside(double low, double high, Level plane)
{
  return planesBeside(low, high, { 0, plane, 200 })[2][1];
}

// Of two boxes' common plane, which halves the space between two meshlines.
Level halfBeside(double low, double high)
{
  const Meshlines planes = planesBeside(low, high, { 0, 12800 });
  return planeAt(planes, 2, FinePerBox / 2);
}

}

TEST(PlanesAside, APlaneUnderARoofStepsAboveIt)
{
  EXPECT_EQ(meshlineBeside(11, 51, 50), 52U); // the domain ends at 51
}

TEST(PlanesAside, APlaneOverAFloorStepsBelowIt)
{
  EXPECT_EQ(meshlineBeside(51, 101, 52), 50U); // the domain begins at 51
}

TEST(PlanesAside, PlanesThatLeaveNoFlangeStay)
{
  EXPECT_EQ(meshlineBeside(11, 51, 52), 52U);
  EXPECT_EQ(meshlineBeside(51, 101, 50), 50U);
  EXPECT_EQ(meshlineBeside(11, 51, 30), 30U);
}

TEST(PlanesAside, APlaneThatDividesABoxStepsToo)
{
  EXPECT_EQ(halfBeside(11, 6401), 6402U);
  EXPECT_EQ(halfBeside(6399, 10001), 6398U);
  EXPECT_EQ(halfBeside(11, 6399), 6400U);
  EXPECT_EQ(halfBeside(11, 6501), 6400U); // far from the wall
}

// The wall runs along the first of the planes that divide the space between two meshlines into 512.
TEST(PlanesAside, PlanesOfDeepBoxesStepToo)
{
  constexpr std::int64_t Step = FinePerBox / 512;
  for (const int depth : { 0, 6, 8, 9, 12 })
  {
    const Meshlines planes = planesBeside(11, 1001, { 0, 512000 }, depth);
    EXPECT_EQ(planes.planeLevel, std::max(6, depth));
    EXPECT_EQ(planeAt(planes, 2, Step), depth < 9 ? 1000U : 1002U) << depth;
    EXPECT_EQ(planeAt(planes, 2, 2 * Step), 2000U);
  }
}

// 0.6 in single precision is 2.4e-8 more: a flange of 25 levels here.
TEST(PlanesAside, WallsInSinglePrecisionRunAlongPlanesInDouble)
{
  const double top = float(0.6);
  Soup soup = box({ 0, 0, 0 }, { 1, 1, 1 });
  soup.add(box({ 2, 0, 0 }, { 3, 1, top }));
  for (const double size :
    { 0.05, 0.1, 0.2, 0.4, 0.8 }) // 0.4: the wall runs along a half; 0.8: a quarter
  {
    const PreparedSurface prepared = prepare(soup, cellsOf(size));
    const auto fine = std::lround(0.6 / size * double(FinePerBox));
    EXPECT_EQ(planeAt(prepared.planes, 2, fine), prepared.surface.lattice.vertex(2, top) + 1)
      << size;
  }
}
