// Moves of nodes: they gain what they say, and stay where the node may be.
#include "Editing/NodeMoves.h"
#include "Support/Turned.h"

#include <gtest/gtest.h>

namespace cartesian
{

namespace
{

// 2 x 2 x 2 boxes of which one node is not where it should be.
struct Moved
{
  MeshEditor mesh;
  std::uint32_t node;
  EditRules rules;
  SearchSpec search;
  Proposal best{};

  Moved(const Vector& from, const Vector& by, const Turn& turn = {})
    : mesh(turnedMesh(
        turn, blockOfBoxes(2, 2, 2), [&](const Vector& p) { return p == from ? plus(p, by) : p; }))
    , node(nodeAt(mesh, turn(plus(from, by))))
  {
  }

  double findAmong(const std::vector<std::uint32_t>& nodes, double least = 0)
  {
    FixedList<std::uint32_t, 16> list;
    for (const std::uint32_t n : nodes)
    {
      list.push(n);
    }
    ProposalTrials trials(mesh, rules);
    trials.setBox(0);
    return bestMove(mesh, trials, rules.objective, search, list, 1, least, best);
  }
  double find(double least = 0) { return findAmong({ node }, least); }

  Vector step() const { return minus(best.at, mesh.node(best.a).at); }
};

const Vector Inside{ 1, 1, 1 };
const Vector OnWall{ 1, 1, 2 };
const Vector OnRim{ 1, 0, 2 };
const Vector Aside{ 0.5, -0.375, 0.4375 };
const Vector AlongWall{ 0.625, -0.5, 0 };
const Vector AlongRim{ 0.75, 0, 0 };

constexpr double Levels = 1e-13;  // places are whole levels: 2^-46
constexpr double Rounding = 1e-9; // of costs

}

// What it says it gains, costs fall by; and it goes back towards the middle.
TEST(NodeMoves, GainWhatTheySay)
{
  for (const auto& [from, by] :
    { std::pair{ Inside, Aside }, { OnWall, AlongWall }, { OnRim, AlongRim } })
  {
    Moved moved(from, by);
    const MeshEditor before = copyOf(moved.mesh);
    const double gain = moved.find();
    ASSERT_GT(gain, 0);
    EXPECT_EQ(moved.best.kind, EditKind::Move);
    EXPECT_EQ(moved.best.a, moved.node);
    EXPECT_LT(dot(moved.step(), by), 0);
    EXPECT_EQ(differenceOf(moved.mesh, before), ""); // nothing is done yet
    ProposalTrials trials(moved.mesh, moved.rules);
    trials.setBox(0);
    ASSERT_TRUE(trials.make(moved.best, 0));
    moved.mesh.commit();
    EXPECT_EQ(moved.mesh.node(moved.node).at, moved.best.at);
    EXPECT_EQ(faultOf(moved.mesh), "");
    measureAgain(moved.mesh);
    EXPECT_NEAR(sumOfCosts(before) - sumOfCosts(moved.mesh), gain, Rounding * gain);
    EXPECT_NEAR(volumeOf(moved.mesh), 8, 1e-12);
  }
}

TEST(NodeMoves, AreNoneWhereNothingIsWrong)
{
  for (const Vector& at : { Inside, OnWall, OnRim })
  {
    EXPECT_EQ(Moved(at, {}).find(), NoGain);
  }
}

TEST(NodeMoves, MustGainMoreThanTheLeast)
{
  Moved moved(Inside, Aside);
  const double gain = moved.find();
  const Proposal best = moved.best;
  ASSERT_GT(gain, 0);
  EXPECT_EQ(moved.find(gain), NoGain);
  moved.search.nodes = 0;
  EXPECT_EQ(moved.find(), NoGain);
  moved.search.nodes = 1;
  EXPECT_EQ(moved.find(), gain);
  EXPECT_EQ(moved.best.at, best.at);
}

// Along the planes that hold it; bit for bit.
TEST(NodeMoves, KeepHeldAxes)
{
  for (const Turn& turn : turns())
  {
    for (std::uint8_t held = 1; held < AllAxes; ++held)
    {
      Moved moved(Inside, Aside, turn);
      moved.mesh.rawNode(moved.node).constrainedAxes = held;
      ASSERT_GT(moved.find(), 0) << int(held);
      for (std::size_t axis = 0; axis < 3; ++axis)
      {
        EXPECT_EQ(moved.step()[axis] == 0, (held >> axis & 1) != 0) << int(held);
      }
    }
    Moved fixed(Inside, Aside, turn);
    fixed.mesh.rawNode(fixed.node).constrainedAxes = AllAxes;
    EXPECT_EQ(fixed.find(), NoGain);
  }
}

TEST(NodeMoves, StayOnTheSurfaceAndOnTheEdge)
{
  for (const Turn& turn : turns())
  {
    Moved top(OnWall, AlongWall, turn);
    ASSERT_EQ(top.mesh.node(top.node).kind, NodeKind::OnSurface);
    ASSERT_GT(top.find(), 0);
    EXPECT_NEAR(top.step()[(2 + turn.axes) % 3], 0, Levels);
    Moved rim(OnRim, AlongRim, turn);
    ASSERT_EQ(rim.mesh.node(rim.node).kind, NodeKind::OnEdge);
    ASSERT_GT(rim.find(), 0);
    EXPECT_NEAR(rim.step()[(1 + turn.axes) % 3], 0, Levels);
    EXPECT_NEAR(rim.step()[(2 + turn.axes) % 3], 0, Levels);
    // Held across its edge it goes nowhere else.
    rim.mesh.rawNode(rim.node).constrainedAxes = static_cast<std::uint8_t>(1 << turn.axes % 3);
    EXPECT_EQ(rim.find(), NoGain);
    rim.mesh.rawNode(rim.node).constrainedAxes = 0;
    rim.mesh.rawNode(rim.node).kind = NodeKind::Corner;
    EXPECT_EQ(rim.find(), NoGain);
  }
}

TEST(NodeMoves, StayWithinTheirMaxDisplacement)
{
  for (const auto& [from, by] : { std::pair{ OnWall, AlongWall }, { OnRim, AlongRim } })
  {
    Moved moved(from, by);
    ASSERT_GT(moved.find(), 0);
    EXPECT_LE(norm(moved.step()), 0.2F);
    ASSERT_GT(norm(moved.step()), 0.0625); // so the limit below is one
    moved.mesh.rawNode(moved.node).maxDisplacement = 0.0625F;
    ASSERT_GT(moved.find(), 0);
    EXPECT_LE(norm(moved.step()), 0.0625);
    moved.mesh.rawNode(moved.node).maxDisplacement = 0;
    EXPECT_EQ(moved.find(), NoGain);
    // Counted from where it was known to be, not from where it is.
    moved.mesh.rawNode(moved.node).maxDisplacement = 0.2F;
    moved.mesh.rawNode(moved.node).referencePosition = plus(moved.mesh.node(moved.node).at, by);
    EXPECT_EQ(moved.find(), NoGain);
    moved.rules.mayChangeWalls = false;
    moved.mesh.rawNode(moved.node).referencePosition = moved.mesh.node(moved.node).at;
    EXPECT_EQ(moved.find(), NoGain);
  }
}

TEST(NodeMoves, DoNotDependOnAxesAndPlace)
{
  for (const auto& [from, by] :
    { std::pair{ Inside, Aside }, { OnWall, AlongWall }, { OnRim, AlongRim } })
  {
    Moved first(from, by);
    const double gain = first.find();
    for (const Turn& turn : turns())
    {
      Moved moved(from, by, turn);
      EXPECT_NEAR(moved.find(), gain, Rounding * gain);
      EXPECT_LT(norm(minus(moved.best.at, turn(first.best.at))), Rounding);
    }
  }
}

// Whatever the order of the nodes; that which gains most of all looked at, which are those with the steepest slopes.
TEST(NodeMoves, DoNotDependOnTheOrderOfNodes)
{
  std::vector<std::uint32_t> nodes(16);
  Moved moved(Inside, Aside);
  for (std::uint32_t n = 0; n < nodes.size(); ++n)
  {
    nodes[n] = n + 6; // with the one in the middle, 13
  }
  ASSERT_EQ(moved.node, 13U);
  const double gain = moved.findAmong(nodes);
  const Proposal best = moved.best;
  ASSERT_GT(gain, 0);
  EXPECT_GE(gain, moved.find());
  std::mt19937 random(3);
  for (int i = 0; i < 20; ++i)
  {
    std::shuffle(nodes.begin(), nodes.end(), random);
    EXPECT_EQ(moved.findAmong(nodes), gain);
    EXPECT_EQ(moved.best.a, best.a);
    EXPECT_EQ(moved.best.at, best.at);
  }
}

}
