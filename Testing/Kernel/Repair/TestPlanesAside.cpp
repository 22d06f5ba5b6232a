// SPDX-License-Identifier: BSD-3-Clause
#include "Repair/PlanesAside.h"

#include "Support/Pipeline.h"

#include <gtest/gtest.h>

using namespace cartesian;

namespace
{

// A box between the levels 11 and 101 along x and y, and those given along z.
Meshlines planesBeside(double low, double high, Level plane)
{
  const Soup soup = box({ 11, 11, low }, { 101, 101, high });
  const PreparedSurface prepared =
    prepareOnLevels(soup, { { { 0, 200 }, { 0, 200 }, { 0, 200 } } });
  Meshlines planes{ { { 0, 200 }, { 0, 200 }, { 0, plane, 200 } } };
  stepAside(prepared.surface, planes);
  return planes;
}

}

TEST(PlanesAside, APlaneUnderARoofStepsAboveIt)
{
  EXPECT_EQ(planesBeside(11, 51, 50)[2][1], 52U); // the domain ends at 51
}

TEST(PlanesAside, APlaneOverAFloorStepsBelowIt)
{
  EXPECT_EQ(planesBeside(51, 101, 52)[2][1], 50U); // the domain begins at 51
}

TEST(PlanesAside, PlanesThatLeaveNoFlangeStay)
{
  EXPECT_EQ(planesBeside(11, 51, 52)[2][1], 52U);
  EXPECT_EQ(planesBeside(51, 101, 50)[2][1], 50U);
  EXPECT_EQ(planesBeside(11, 51, 30)[2][1], 30U);
}
