// SPDX-License-Identifier: BSD-3-Clause
#include "Acceptance/CellCost.h"
#include "Support/CellShapes.h"

#include <gtest/gtest.h>

using namespace cartesian;

namespace
{

double costTowards(const Polyhedron& cell, std::size_t face, const NeighbourCell& neighbour)
{
  return costOfFace(cell, shapeOf(cell), face, neighbour);
}

}

TEST(CellCost, ACubeAmongCubesCostsHardlyAnything)
{
  const Polyhedron cell = boxOf(100, 100, 100, false);
  EXPECT_LT(costTowards(cell, 3, { { 150, 50, 50 }, 1e6 }), 0.05);
  EXPECT_LT(costTowards(boxOf(100, 100, 100, true), 3, {}), 1e-9);
}

TEST(CellCost, RisesWithWhatSolversSufferFrom)
{
  const Polyhedron cell = boxOf(100, 100, 100, false);
  const double straight = costTowards(cell, 3, { { 150, 50, 50 }, 1e6 });
  const double askew = costTowards(cell, 3, { { 150, 120, 50 }, 1e6 });
  const double near = costTowards(cell, 3, { { 102, 50, 50 }, 1e6 });
  const double small = costTowards(cell, 3, { { 150, 50, 50 }, 1e3 });
  EXPECT_GT(askew, straight);
  EXPECT_GT(near, straight);
  EXPECT_GT(small, straight);
}

// A box with inner faces on some sides only.
Polyhedron boxWithInner(std::initializer_list<std::size_t> inner)
{
  Polyhedron cell = boxOf(100, 100, 100, true);
  for (const std::size_t face : inner)
  {
    cell.isBoundary[face] = 0;
  }
  return cell;
}

TEST(CellCost, InnerFacesHaveToLieInAllDirections)
{
  const auto cost = [](const Polyhedron& cell) {
    const CellShape shape = shapeOf(cell);
    return std::make_pair(costOfDeterminant(cell, shape), isEasy(cell, shape));
  };
  EXPECT_NEAR(cost(boxWithInner({ 0, 1, 2, 3, 4, 5 })).first, 0.02, 1e-12); // the determinant is 1
  EXPECT_NEAR(cost(boxWithInner({ 0, 2, 3 })).first, 0.16, 1e-12);          // 1/8
  EXPECT_TRUE(cost(boxWithInner({ 0, 2, 3 })).second);
  for (const Polyhedron& flat : { boxWithInner({ 0, 1 }), boxWithInner({ 0, 2 }),
         boxWithInner({ 5 }), boxWithInner({ 0, 1, 2, 4 }) })
  {
    EXPECT_EQ(cost(flat).first, 8);
    EXPECT_FALSE(cost(flat).second);
  }
}

TEST(CellCost, AFailedAngleOutweighsAllElse)
{
  const Polyhedron cell = boxOf(100, 100, 100, false);
  EXPECT_GE(costTowards(cell, 3, { { 90, 250, 50 }, 1e6 }), 1e3);
  EXPECT_LE(costOfShare(1e-12), 100);
  EXPECT_EQ(costOfShare(1), 0);
}
