// What is accepted, one parameter after the other; and what solvers make of single cells.
#include "Acceptance/Acceptance.h"
#include "Acceptance/CellCost.h"
#include "Support/CellShapes.h"

#include <gtest/gtest.h>

using namespace cartesian;

namespace
{

Verdict verdict(double cost, double worst = 0, std::size_t refused = 0)
{
  Verdict result;
  result.cost = cost;
  result.worst = worst;
  result.refused = refused;
  result.faces = 6;
  result.volume = 1;
  return result;
}

constexpr Acceptance Anything{ MayRefuse::AsMany };

bool acceptsRefused(MayRefuse may, std::size_t before, std::size_t after)
{
  return accepts({ may }, verdict(1, 1, before), verdict(1, 1, after));
}

}

TEST(Acceptance, OfRefusedFaces)
{
  EXPECT_TRUE(acceptsRefused(MayRefuse::NoFace, 2, 0));
  EXPECT_FALSE(acceptsRefused(MayRefuse::NoFace, 2, 1));
  EXPECT_TRUE(acceptsRefused(MayRefuse::FewerOrNone, 0, 0));
  EXPECT_TRUE(acceptsRefused(MayRefuse::FewerOrNone, 2, 1));
  EXPECT_FALSE(acceptsRefused(MayRefuse::FewerOrNone, 2, 2));
  EXPECT_TRUE(acceptsRefused(MayRefuse::AsMany, 2, 2));
  EXPECT_FALSE(acceptsRefused(MayRefuse::AsMany, 2, 3));
}

TEST(Acceptance, OfWhatCostsFall)
{
  Acceptance acceptance = Anything;
  acceptance.leastGain = 2;
  EXPECT_TRUE(accepts(acceptance, verdict(10), verdict(7.9)));
  EXPECT_FALSE(accepts(acceptance, verdict(10), verdict(8)));
  Verdict after = verdict(7);
  EXPECT_EQ(gain(verdict(10), after), 3);
  after.costBeyond = 1.5; // what others lose counts
  EXPECT_EQ(gain(verdict(10), after), 1.5);
  EXPECT_FALSE(accepts(acceptance, verdict(10), after));
}

TEST(Acceptance, OfTheWorst)
{
  Acceptance acceptance = Anything;
  acceptance.mostWorst = 5;
  EXPECT_TRUE(accepts(acceptance, verdict(1, 1), verdict(1, 5)));
  EXPECT_FALSE(accepts(acceptance, verdict(1, 1), verdict(1, 5.1)));
  EXPECT_TRUE(accepts(acceptance, verdict(1, 9), verdict(1, 9)));
  EXPECT_FALSE(accepts(acceptance, verdict(1, 9), verdict(1, 9.1)));
  acceptance.worstFalls = true;
  EXPECT_FALSE(accepts(acceptance, verdict(1, 9), verdict(1, 9)));
  EXPECT_TRUE(accepts(acceptance, verdict(1, 9), verdict(1, 8.9)));
}

TEST(Acceptance, OfFacesAndVolume)
{
  Acceptance acceptance = Anything;
  Verdict after = verdict(1);
  after.faces = 3;
  after.volume = 0.01;
  EXPECT_TRUE(accepts(acceptance, verdict(1), after));
  acceptance.leastFaces = LeastFaces;
  EXPECT_FALSE(accepts(acceptance, verdict(1), after));
  after.faces = 4;
  EXPECT_TRUE(accepts(acceptance, verdict(1), after));
  acceptance.leastVolume = 0.8;
  acceptance.mostVolume = 1.25;
  for (const auto& [volume, is] : std::vector<std::pair<double, bool>>{
         { 0.79, false }, { 0.81, true }, { 1.24, true }, { 1.26, false }, { -1, false } })
  {
    after.volume = volume;
    EXPECT_EQ(accepts(acceptance, verdict(1), after), is) << volume;
    EXPECT_EQ(keepsShape(acceptance, verdict(1), after), is) << volume;
  }
}

TEST(Acceptance, NothingThatMustNotBe)
{
  EXPECT_FALSE(accepts(Anything, verdict(1), verdict(Never)));
  Verdict after = verdict(1);
  after.costBeyond = 2 * Never;
  EXPECT_FALSE(accepts(Anything, verdict(1), after));
}

// What the steps have in common, whatever their numbers: nobody makes a mesh worse that solvers accept.
TEST(Acceptance, NoStepMakesAFaceThatSolversRefuse)
{
  for (const Acceptance& acceptance :
    { Accepted::SmallMerge, Accepted::PoorMerge, Accepted::Join, Accepted::Mend, Accepted::Wall,
      Accepted::TipRemoval, Accepted::Removal, Accepted::LeftBehind, Accepted::Ceded })
  {
    EXPECT_TRUE(accepts(acceptance, verdict(10, 1), verdict(1, 1)));
    EXPECT_FALSE(accepts(acceptance, verdict(10, 1), verdict(1, 1, 1)));
  }
}

TEST(Verdict, OfACubeIsFair)
{
  const Polyhedron cube = boxOf(100, 100, 100, false);
  const Verdict fair = evaluate(cube, shapeOf(cube), cubesAround(100));
  EXPECT_LT(fair.worst, 0.05);
  EXPECT_LT(fair.cost, 6 * 0.05);
  EXPECT_EQ(fair.refused, 0U);
  EXPECT_EQ(fair.invalid, 0U);
  EXPECT_EQ(fair.faces, 6U);
  EXPECT_NEAR(fair.volume, 1e6, 1e-3);
  const Polyhedron alone = boxOf(100, 100, 100, true);
  EXPECT_NEAR(evaluate(alone, shapeOf(alone), std::vector<NeighbourCell>(6)).cost, 0, 1e-9);
}

TEST(Verdict, OfASquashedCubeIsWorseThoughAccepted)
{
  const Polyhedron cube = boxOf(100, 100, 100, false);
  const Polyhedron flat = boxOf(100, 100, 15, false);
  std::vector<NeighbourCell> beyond = cubesAround(100);
  beyond[1].centre[2] = 65; // on top of it
  for (const std::size_t side : { 2, 3, 4, 5 })
  {
    beyond[side].centre[2] = 7.5;
  }
  const Verdict verdict = evaluate(flat, shapeOf(flat), beyond);
  EXPECT_GT(verdict.cost, 2 * evaluate(cube, shapeOf(cube), cubesAround(100)).cost);
  EXPECT_EQ(verdict.refused, 0U);
  EXPECT_LT(verdict.toMend, 2U); // the centres are off towards these
}

TEST(Verdict, CountsFacesThatAreTurnedOver)
{
  const Polyhedron cube = boxOf(100, 100, 100, false);
  std::vector<NeighbourCell> beyond = cubesAround(100);
  beyond[3].centre = { 90, 50, 50 }; // before the face
  const Verdict turned = evaluate(cube, shapeOf(cube), beyond);
  EXPECT_EQ(turned.refused, 1U);
  EXPECT_EQ(turned.invalid, 1U);
  EXPECT_EQ(turned.toMend, 3U);
  EXPECT_GE(turned.worst, 1e3);
  beyond[3].centre = { 110, 150, 50 }; // refused, but behind it
  EXPECT_EQ(evaluate(cube, shapeOf(cube), beyond).refused, 1U);
  EXPECT_EQ(evaluate(cube, shapeOf(cube), beyond).invalid, 0U);
  std::vector<std::uint8_t> counts(6, 1);
  counts[3] = 0;
  EXPECT_EQ(evaluate(cube, shapeOf(cube), beyond, counts).refused, 0U);
}

TEST(Verdict, MendsWhatCostsMostOfWhatIsRefused)
{
  const Polyhedron cube = boxOf(100, 100, 100, false);
  for (const std::uint32_t worst : { 1U, 3U })
  {
    std::vector<NeighbourCell> beyond = cubesAround(100);
    beyond[1].centre = { 50, 50, 90 };
    beyond[3].centre = { 90, 50, 50 };
    beyond[4 - worst].centre[1] += 40; // not straight before the face
    EXPECT_EQ(evaluate(cube, shapeOf(cube), beyond).refused, 2U);
    EXPECT_EQ(evaluate(cube, shapeOf(cube), beyond).toMend, worst);
  }
}

TEST(Verdict, EndsWhereTheCostIsLargerThanAsked)
{
  const Polyhedron cube = boxOf(100, 100, 100, false);
  std::vector<NeighbourCell> beyond = cubesAround(100);
  beyond[0].centre = beyond[3].centre = { 50, 50, 50 };
  EXPECT_EQ(evaluate(cube, shapeOf(cube), beyond).refused, 2U);
  EXPECT_EQ(evaluate(cube, shapeOf(cube), beyond, {}, 100).refused, 1U);
}

TEST(Verdict, OfACellAddsWhatItIsItself)
{
  const Polyhedron cube = boxOf(100, 100, 100, false);
  const CellShape shape = shapeOf(cube);
  const Verdict faces = evaluate(cube, shape, cubesAround(100));
  const Verdict whole = evaluateCell(cube, shape, cubesAround(100), 1);
  EXPECT_NEAR(whole.cost, faces.cost + costOfDeterminant(cube, shape), 1e-12);
  const Verdict small = evaluateCell(cube, shape, cubesAround(100), 0.03);
  EXPECT_NEAR(small.cost - whole.cost, 25, 1e-9);
  EXPECT_NEAR(small.worst, 25, 1e-9);
  const Polyhedron wedge = cellOf({ { 0, 0, 0 }, { 9, 0, 0 }, { 0, 9, 0 }, { 0, 0, 9 } },
    { { 0, 2, 1 }, { 0, 1, 3 }, { 1, 2, 3 } }, true); // one face is missing
  EXPECT_EQ(evaluateCell(wedge, shapeOf(wedge), std::vector<NeighbourCell>(3), 1).refused,
    evaluate(wedge, shapeOf(wedge), std::vector<NeighbourCell>(3)).refused + 1);
}

TEST(Verdict, OfSeveralCellsIsTheSum)
{
  Verdict sum;
  sum += verdict(1, 3, 2);
  Verdict other = verdict(4, 2, 1);
  other.faces = 5;
  other.invalid = 1;
  other.costBeyond = 7;
  sum += other;
  EXPECT_EQ(sum.cost, 5);
  EXPECT_EQ(sum.worst, 3);
  EXPECT_EQ(sum.refused, 3U);
  EXPECT_EQ(sum.invalid, 1U);
  EXPECT_EQ(sum.faces, 5U);
  EXPECT_EQ(sum.volume, 2);
  EXPECT_EQ(sum.costBeyond, 7);
}
