// Boxes along bodies, around them and in their wake, where the user asks for nothing but a number.

#include "Boxes/FlowRefinement.h"

#include "Base/Error.h"

#include <gtest/gtest.h>

using namespace cartesian;

namespace
{

// A body 4 long, in a box that ends 4 before and 12 behind it.
constexpr Bounds Body{ { 0, 0, 0 }, { 4, 2, 1 } };

DomainSpec domain()
{
  DomainSpec spec;
  spec.domain = Domain::Outside;
  spec.before = 1;
  spec.behind = 3;
  spec.beside = 1;
  return spec;
}

GridSpec boxesOf(double size)
{
  GridSpec grid;
  grid.cellSize = size;
  return grid;
}

void expectBounds(const Bounds& actual, const Bounds& expected)
{
  EXPECT_EQ(actual.low, expected.low);
  EXPECT_EQ(actual.high, expected.high);
}

}

TEST(FlowRefinement, HalvesUntilThereAreEnoughBoxesAlongTheBody)
{
  DomainSpec spec = domain();
  for (const auto& [boxes, depth] :
    { std::pair(0, 0), std::pair(4, 0), std::pair(5, 1), std::pair(8, 1), std::pair(60, 4),
      std::pair(64, 4), std::pair(65, 5), std::pair(1000, 8) })
  {
    spec.boxesAlong = boxes;
    EXPECT_EQ(flowRefinement(spec, boxesOf(1), Body).depth, depth) << boxes;
  }
  spec.boxesAlong = 1001;
  EXPECT_THROW(flowRefinement(spec, boxesOf(1), Body), Error);
}

TEST(FlowRefinement, TellsHowManyBoxesItReaches)
{
  DomainSpec spec = domain();
  spec.boxFrom = BoxSource::Bounds;
  spec.bounds = { { -4096, -4096, -4096 }, { 4096, 4096, 4096 } };
  for (const auto& [boxes, isEnough] : { std::pair(0, true), std::pair(60, true),
         std::pair(256, true), std::pair(257, false), std::pair(1000, false) })
  {
    spec.boxesAlong = boxes;
    const FlowRefinement flow = flowRefinement(spec, boxesOf(64), Body);
    EXPECT_EQ(flow.hasAlong(boxes), isEnough) << boxes;
    EXPECT_EQ(flow.length, 4);
    EXPECT_EQ(flow.size, 64. / (1 << flow.depth));
  }
}

TEST(FlowRefinement, ZonesAreAroundTheBodyAndInItsWake)
{
  DomainSpec spec = domain();
  spec.boxesAlong = 16;
  FlowRefinement flow = flowRefinement(spec, boxesOf(1), Body);
  EXPECT_EQ(flow.depth, 2);
  ASSERT_EQ(flow.zones.size(), 1); // the wake has depth 0
  spec.boxesAlong = 60;
  spec.ground = DomainSide::ZMin;
  flow = flowRefinement(spec, boxesOf(1), Body);
  ASSERT_EQ(flow.zones.size(), 2);
  EXPECT_EQ(flow.zones[0].depth, 3);
  expectBounds(flow.zones[0].box, { { -1, -1, 0 }, { 5, 3, 2 } });
  EXPECT_EQ(flow.zones[1].depth, 2);
  expectBounds(flow.zones[1].box, { { -1, -1, 0 }, { 12, 3, 2 } });
  spec.flow = FlowDirection::MinusX;
  expectBounds(flowRefinement(spec, boxesOf(1), Body).zones[1].box, { { -8, -1, 0 }, { 5, 3, 2 } });
}

TEST(FlowRefinement, ZonesAndBodiesEndWithTheBox)
{
  DomainSpec spec = domain();
  spec.boxFrom = BoxSource::Bounds;
  spec.bounds = { { 2, -8, -8 }, { 10, 8, 8 } }; // cuts the body in halves, 2 long
  spec.boxesAlong = 30;
  const FlowRefinement flow = flowRefinement(spec, boxesOf(1), Body);
  EXPECT_EQ(flow.depth, 4);
  expectBounds(flow.zones[1].box, { { 2, -0.5, -0.5 }, { 8, 2.5, 1.5 } });
}

// Where meshlines are near each other, boxes are small already.
TEST(FlowRefinement, CountsBoxesBetweenMeshlines)
{
  GridSpec grid = boxesOf(1);
  grid.meshlines[0] = { -4, 0, 2, 4, 16 };
  DomainSpec spec = domain();
  spec.boxesAlong = 4;
  EXPECT_EQ(flowRefinement(spec, grid, Body).depth, 1);
}
