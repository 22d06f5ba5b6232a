// Which edits may be made.
#include "Editing/EditDecision.h"
#include "Support/EditMeshes.h"

#include <gtest/gtest.h>

namespace cartesian
{

namespace
{

// Of 3 x 3 x 3 boxes; nodes by where they are.
class Collapses
{
public:
  explicit Collapses(MeshEditor mesh)
    : mesh_(std::move(mesh))
  {
  }

  bool may(const Vector& u, const Vector& v) { return may(u, v, v); }
  bool may(const Vector& u, const Vector& v, const Vector& at)
  {
    charge = 0;
    return mayCollapse(mesh_, rules, nodeAt(mesh_, u), nodeAt(mesh_, v), at, charge);
  }
  EditNode& node(const Vector& at) { return mesh_.rawNode(nodeAt(mesh_, at)); }

  EditRules rules;
  double charge = 0;

private:
  MeshEditor mesh_;
};

MeshEditor block(std::uint8_t held = 0)
{
  TestMeshSpec spec;
  spec.constrainedAxes = held;
  return meshOfBoxes(blockOfBoxes(3, 3, 3), spec);
}

}

TEST(MayCollapse, TowardsHigherKindsOnly)
{
  Collapses of(block());
  const Vector corner{ 0, 0, 0 };
  const Vector edge{ 1, 0, 0 };
  const Vector surface{ 1, 1, 0 };
  const Vector inside{ 1, 1, 1 };
  EXPECT_TRUE(of.may(inside, surface));
  EXPECT_FALSE(of.may(surface, inside));
  EXPECT_TRUE(of.may(surface, edge));
  EXPECT_FALSE(of.may(edge, surface));
  EXPECT_TRUE(of.may(edge, corner)); // along the edge
  EXPECT_EQ(of.charge, 0);
  EXPECT_TRUE(of.may(edge, { 2, 0, 0 }));
  EXPECT_EQ(of.charge, 0);
  EXPECT_FALSE(of.may(corner, edge)); // the edges beside it would move by half a box and more
  EXPECT_TRUE(of.may(surface, { 2, 1, 0 }));
  EXPECT_TRUE(of.may(inside, { 2, 1, 1 }));
}

TEST(MayCollapse, CornersStayWhereTheyAre)
{
  Collapses of(block());
  EXPECT_FALSE(of.may({ 1, 0, 0 }, { 0, 0, 0 }, { 0.5, 0, 0 }));
  EXPECT_TRUE(of.may({ 1, 0, 0 }, { 2, 0, 0 }, { 1.5, 0, 0 }));
  EXPECT_TRUE(of.may({ 1, 1, 1 }, { 1, 1, 2 }, { 1, 1, 1.5 }));
}

// From one wall to another through the inside.
TEST(MayCollapse, NotThroughTheInside)
{
  Collapses of(meshOfBoxes(blockOfBoxes(3, 3, 1)));
  EXPECT_FALSE(of.may({ 1, 1, 0 }, { 1, 1, 1 }));
}

TEST(MayCollapse, HeldNodesStayOnTheirPlanes)
{
  Collapses of(block(4));
  EXPECT_TRUE(of.may({ 1, 1, 1 }, { 1, 1, 0 }));
  EXPECT_TRUE(of.may({ 1, 1, 0 }, { 2, 1, 0 }));
  EXPECT_TRUE(of.may({ 1, 1, 0 }, { 2, 1, 0 }, { 1.5, 1, 0 }));
  EXPECT_FALSE(of.may({ 1, 1, 0 }, { 2, 1, 0 }, { 1.5, 1, 0.25 }));
  EXPECT_FALSE(of.may({ 1, 1, 1 }, { 1, 1, 0 }, { 1, 1, 0.5 }));
  of.node({ 1, 0, 0 }).constrainedAxes = 6; // on two planes, then also at the inner end of an edge
  EXPECT_FALSE(of.may({ 1, 0, 0 }, { 1, 1, 0 }));
  EXPECT_FALSE(of.may({ 1, 0, 0 }, { 2, 0, 0 }));
}

// A domain of one box between two planes that hold: each node on its own.
TEST(MayCollapse, NotFromOnePlaneToTheOther)
{
  TestMeshSpec spec;
  spec.constrainedAxes = 4;
  Collapses of(meshOfBoxes(blockOfBoxes(3, 3, 1), spec));
  for (const Vector& at : { Vector{ 1, 1, 0 }, Vector{ 1, 1, 1 } }) // as if no wall were there
  {
    of.node(at).kind = NodeKind::Free;
    of.node(at).atWall = false;
  }
  EXPECT_FALSE(of.may({ 1, 1, 0 }, { 1, 1, 1 }));
  EXPECT_FALSE(of.may({ 1, 1, 0 }, { 1, 1, 1 }, { 1, 1, 0.5 }));
}

TEST(MayCollapse, NodesHeldFastStay)
{
  Collapses of(block());
  of.node({ 1, 1, 1 }).constrainedAxes = AllAxes;
  EXPECT_FALSE(of.may({ 1, 1, 1 }, { 2, 1, 1 }));
  EXPECT_TRUE(of.may({ 2, 1, 1 }, { 1, 1, 1 }));
  EXPECT_FALSE(of.may({ 2, 1, 1 }, { 1, 1, 1 }, { 1.5, 1, 1 }));
  of.node({ 2, 1, 1 }).constrainedAxes = AllAxes;
  EXPECT_FALSE(of.may({ 2, 1, 1 }, { 1, 1, 1 }));
}

// Off the edge by a little: for a charge.
TEST(MayCollapse, ChargesForAnEdgeThatMoves)
{
  for (const double off : { 0.0625, 0.125, 0.5 })
  {
    Collapses of(meshOfBoxes(blockOfBoxes(3, 1, 1), { [&](const Vector& p) {
      return Vector{ p[0], p[1], p[0] == 1 && p[2] == 0 && p[1] == 0 ? p[2] - off : p[2] };
    } }));
    of.node({ 1, 0, -off }).kind = NodeKind::OnEdge;
    const bool may = of.may({ 1, 0, -off }, { 2, 0, 0 });
    EXPECT_EQ(may, off < of.rules.objective.mostMoved);
    EXPECT_GT(of.charge, 0);
  }
}

TEST(MayMove, AlongTheLeashOnly)
{
  MeshEditor mesh = block();
  const std::uint32_t surface = nodeAt(mesh, { 1, 1, 0 });
  mesh.rawNode(surface).maxDisplacement = 0.25F;
  EXPECT_TRUE(mayMove(mesh, EditRules(), surface, { 1.25, 1, 0 }));
  EXPECT_FALSE(mayMove(mesh, EditRules(), surface, { 1.26, 1, 0 }));
  mesh.rawNode(surface).referencePosition = { 1.125, 1, 0 };
  EXPECT_TRUE(mayMove(mesh, EditRules(), surface, { 1.26, 1, 0 }));
  EXPECT_TRUE(mayMove(mesh, EditRules(), nodeAt(mesh, { 1, 1, 1 }), { 1.75, 1, 1 }));
  EXPECT_FALSE(mayMove(mesh, EditRules(), nodeAt(mesh, { 0, 0, 0 }), { 0.01, 0, 0 }));
}

TEST(MayMove, NotAlongWallsThatMustNotChange)
{
  MeshEditor mesh = block();
  mesh.rawNode(nodeAt(mesh, { 1, 1, 0 })).maxDisplacement = 0.25F;
  EditRules rules;
  rules.mayChangeWalls = false;
  EXPECT_FALSE(mayMove(mesh, rules, nodeAt(mesh, { 1, 1, 0 }), { 1.25, 1, 0 }));
  EXPECT_TRUE(mayMove(mesh, rules, nodeAt(mesh, { 1, 1, 1 }), { 1.25, 1, 1 }));
}

TEST(MayMove, HeldNodesStayOnTheirPlanes)
{
  MeshEditor mesh = block(4);
  const std::uint32_t n = nodeAt(mesh, { 1, 1, 0 });
  EXPECT_TRUE(mayMove(mesh, EditRules(), n, { 1.125, 1, 0 }));
  EXPECT_FALSE(mayMove(mesh, EditRules(), n, { 1.125, 1, 0.01 }));
  const std::uint32_t inside = nodeAt(mesh, { 1, 1, 1 });
  mesh.rawNode(inside).constrainedAxes = AllAxes;
  EXPECT_FALSE(mayMove(mesh, EditRules(), inside, { 1.125, 1, 1 }));
}

TEST(MayMerge, AsTheSmallerCellIsSmall)
{
  const MeshEditor mesh = block(); // of whole boxes
  EditRules rules;
  EXPECT_TRUE(mayMerge(mesh, rules, 0, 1));
  rules.mostMerged = 1.5;
  EXPECT_TRUE(mayMerge(mesh, rules, 0, 1));
  rules.mostMerged = 0.3;
  EXPECT_FALSE(mayMerge(mesh, rules, 0, 1));
}

TEST(MayJoin, ChargesForSharpEdges)
{
  EditRules rules;
  for (const double depth : { 0.0, 0.125, 0.5 }) // turns of 0, 14 and 53 degrees
  {
    MeshEditor mesh = dentedCell(depth);
    std::vector<std::uint32_t> upper;
    for (const std::uint32_t f : mesh.facesOf(0))
    {
      if (mesh.face(f).wall == 5)
      {
        upper.push_back(f);
      }
    }
    ASSERT_EQ(upper.size(), 2);
    double charge = 0;
    EXPECT_TRUE(mayJoin(mesh, rules, upper[0], upper[1], charge));
    EXPECT_EQ(charge > 0, depth == 0.5);
  }
}

std::array<std::uint32_t, 2> upperWalls(const MeshEditor& mesh)
{
  std::array<std::uint32_t, 2> upper{ None, None };
  for (const std::uint32_t f : mesh.facesOf(0))
  {
    if (mesh.face(f).wall == 5)
    {
      upper[upper[0] == None ? 0 : 1] = f;
    }
  }
  return upper;
}

// Where the surface knows its edges, those between nodes on edges count, flat as they may be.
TEST(MayJoin, ChargesForKnownEdges)
{
  for (const bool isKnown : { false, true })
  {
    for (const bool isOnEdge : { false, true })
    {
      const double depth = 0.03125; // a turn of 4 degrees
      MeshEditor mesh = dentedCell(depth);
      for (const double y : { 0.0, 1.0 })
      {
        mesh.rawNode(nodeAt(mesh, { 1, y, 1 - depth })).kind =
          isOnEdge ? NodeKind::OnEdge : NodeKind::OnSurface;
      }
      mesh.mesh().sharp = SharpRule(180, isKnown);
      double charge = 0;
      const auto [f, g] = upperWalls(mesh);
      EXPECT_TRUE(mayJoin(mesh, EditRules(), f, g, charge));
      EXPECT_EQ(charge > 0, isOnEdge && isKnown);
    }
  }
}

// An edge of 14 degrees is sharp by a small feature angle; one of 53 by any: boxes have kept it.
TEST(MayJoin, ChargesByTheFeatureAngle)
{
  for (const double featureAngle : { 10.0, 30.0, 75.0, 180.0 })
  {
    for (const double depth : { 0.125, 0.5 })
    {
      MeshEditor mesh = dentedCell(depth);
      mesh.mesh().sharp = SharpRule(featureAngle);
      double charge = 0;
      const auto [f, g] = upperWalls(mesh);
      EXPECT_TRUE(mayJoin(mesh, EditRules(), f, g, charge));
      EXPECT_EQ(charge > 0, featureAngle == 10 || depth == 0.5) << featureAngle;
    }
  }
}

TEST(MayCollapse, ChargesForAKnownEdgeThatMoves)
{
  TestMeshSpec spec;
  spec.place = [](const Vector& p) { // a flat ridge
    return Vector{ p[0], p[1], p[2] == 3 && p[0] == 1 ? 3.03125 : p[2] };
  };
  const Vector ridge{ 1, 1, 3.03125 };
  for (const bool isKnown : { false, true })
  {
    MeshEditor mesh = meshOfBoxes(blockOfBoxes(3, 3, 3), spec);
    for (const double y : { 0.0, 1.0, 2.0, 3.0 })
    {
      mesh.rawNode(nodeAt(mesh, { 1, y, 3.03125 })).kind = NodeKind::OnEdge;
    }
    mesh.mesh().sharp = SharpRule(30, isKnown);
    double charge = 0;
    const bool may = mayCollapse(
      mesh, EditRules(), nodeAt(mesh, ridge), nodeAt(mesh, { 2, 1, 3 }), { 2, 1, 3 }, charge);
    EXPECT_EQ(may, !isKnown); // a node on an edge does not become one beside it
    charge = 0;
    EXPECT_TRUE(mayCollapse(mesh, EditRules(), nodeAt(mesh, ridge), nodeAt(mesh, { 1, 2, 3.03125 }),
      { 1.0625, 2, 3.03125 }, charge));
    EXPECT_EQ(charge > 0, isKnown);
  }
}

// What gains is decided by the objective; not what fails, nor a wall that moves far.
TEST(Decide, ByTheGain)
{
  MeshEditor mesh = meshOfBoxes(blockOfBoxes(3, 3, 3), { [](const Vector& p) {
    return p == Vector{ 1, 1, 1 } ? Vector{ 1.25, 1.25, 1.25 } : p;
  } });
  const EditRules rules;
  const MeshEditor::Mark mark = mesh.mark();
  mesh.moveNode(nodeAt(mesh, { 1.25, 1.25, 1.25 }), { 1, 1, 1 });
  ASSERT_TRUE(updateAndValidate(mesh, rules.objective));
  const double gain = decide(mesh, rules, mark, 1, 0);
  EXPECT_DOUBLE_EQ(gain, -mesh.delta.cost);
  EXPECT_GT(gain, 0);
  EXPECT_EQ(decide(mesh, rules, mark, 1, 2 * gain), -std::numeric_limits<double>::infinity());
}

TEST(Decide, RefusesWhatFails)
{
  MeshEditor mesh = block();
  const EditRules rules;
  const MeshEditor::Mark mark = mesh.mark();
  mesh.moveNode(nodeAt(mesh, { 1, 1, 1 }), { 2.5, 2.5, 1.5 });
  if (updateAndValidate(mesh, rules.objective))
  {
    EXPECT_GT(mesh.delta.failures, 0);
    EXPECT_EQ(decide(mesh, rules, mark, 1, -1e9), -std::numeric_limits<double>::infinity());
  }
}

TEST(Decide, RefusesWallsThatMoveFar)
{
  for (const double height : { 0.0625, 0.375 })
  {
    MeshEditor mesh = block();
    const EditRules rules;
    const MeshEditor::Mark mark = mesh.mark();
    mesh.moveNode(nodeAt(mesh, { 1, 1, 0 }), { 1, 1, -height });
    ASSERT_TRUE(updateAndValidate(mesh, rules.objective));
    EXPECT_NEAR(mesh.delta.volume, 4 * height / 4, 1e-12); // fans about the means of corners
    EXPECT_EQ(mesh.delta.failures, 0);
    EXPECT_EQ(decide(mesh, rules, mark, 1, -1e9) > -1e9, height < rules.objective.mostMoved);
  }
}

// A trial ends where it cannot gain enough; what remains is undone.
TEST(Settle, StopsWhereItGainsTooLittle)
{
  MeshEditor mesh = block();
  const MeshEditor before = copyOf(mesh);
  for (const double gain : { -0.01, -100.0 })
  {
    const MeshEditor::Mark mark = mesh.mark();
    mesh.moveNode(nodeAt(mesh, { 1, 1, 1 }), { 1.5, 1.5, 1.5 });
    EXPECT_EQ(updateAndValidate(mesh, ObjectiveSpec(), { gain, 1 }), gain < -1);
    EXPECT_EQ(mesh.dirty.faces.size(), 0);
    mesh.undo(mark);
    EXPECT_EQ(differenceOf(mesh, before), "");
  }
}

}
