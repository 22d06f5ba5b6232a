// What the loop and all steps together keep, on blocks of boxes whose nodes were moved.
#include "Support/EditMeshes.h"
#include "Support/Effort.h"

#include <gtest/gtest.h>

#include <map>

namespace cartesian
{

namespace
{

// Of 4 x 4 x 3 boxes with nodes moved by up to `moved`: those of walls along them; corners stay.
MeshEditor movedBlock(unsigned seed, double moved, std::uint8_t held = 0, const Vector& from = {},
  bool isMirrored = false)
{
  std::mt19937 random(seed);
  std::uniform_real_distribution<double> by(-moved, moved);
  TestMeshSpec spec;
  spec.constrainedAxes = held;
  constexpr std::array<double, 3> Size{ 4, 4, 3 };
  std::map<Vector, Vector> places;
  for (int i = 0; i < 100; ++i)
  {
    const Vector p{ double(i / 20), double(i / 4 % 5), double(i % 4) };
    for (std::size_t axis = 0; axis < 3; ++axis)
    {
      const double step = std::round(by(random) * 4096) / 4096;
      places[p][axis] = p[axis] + (p[axis] == 0 || p[axis] == Size[axis] ? 0 : step);
    }
  }
  spec.place = [&](const Vector& p) {
    const Vector& at = places.at({ isMirrored ? Size[0] - p[0] : p[0], p[1], p[2] });
    return plus(from, { isMirrored ? Size[0] - at[0] : at[0], at[1], at[2] });
  };
  return meshOfBoxes(blockOfBoxes(4, 4, 3), spec);
}

struct Failures
{
  int failing = 0;
  int straining = 0;

  explicit Failures(const MeshEditor& mesh)
  {
    for (std::uint32_t f = 0; f < mesh.faceCount(); ++f)
    {
      failing += mesh.face(f).gone || mesh.face(f).fails == 0 ? 0 : 1;
      straining += mesh.face(f).gone || !mesh.face(f).strains ? 0 : 1;
    }
  }
};

// All corners of walls are in the planes of these: none of them moved off the surface.
void expectFlatWalls(const MeshEditor& mesh)
{
  for (std::uint32_t f = 0; f < mesh.faceCount(); ++f)
  {
    const EditFace& face = mesh.face(f);
    if (face.gone || !mesh.isWall(f))
    {
      continue;
    }
    const auto axis = static_cast<std::size_t>(face.wall / 2);
    const double plane = face.wall % 2 == 0 ? 0 : axis == 2 ? 3 : 4;
    for (const std::uint32_t n : mesh.cornersOf(f))
    {
      EXPECT_NEAR(mesh.node(n).at[axis], plane, 1e-11);
    }
  }
}

using Step = void (*)(MeshEditor&);

constexpr std::array<Step, 2> Steps{ [](MeshEditor& mesh) { runLoop(mesh, LoopSpec()); },
  improveWhole };

}

TEST(EditLoop, LowersCosts)
{
  for (unsigned seed = 0; seed < repeats(10); ++seed)
  {
    MeshEditor mesh = movedBlock(seed, 0.4);
    const double cost = sumOfCosts(mesh);
    const Failures before(mesh);
    runLoop(mesh, LoopSpec());
    EXPECT_EQ(faultOf(mesh), "");
    EXPECT_LT(sumOfCosts(mesh), 0.9 * cost);
    const Failures after(mesh);
    EXPECT_LE(after.failing, before.failing);
    MeshEditor fresh = copyOf(mesh);
    measureAgain(fresh);
    EXPECT_NEAR(sumOfCosts(fresh), sumOfCosts(mesh), 1e-9 * cost); // what the loop knows is true
  }
}

TEST(EditLoop, LeavesNoFaultOfMeshesAtRandom)
{
  std::mt19937 random(7);
  int count = 0;
  for (unsigned i = 0; i < repeats(60); ++i)
  {
    MeshEditor mesh = randomMesh(random, 0.35);
    if (!faultOf(mesh).empty())
    {
      continue;
    }
    ++count;
    const double cost = sumOfCosts(mesh);
    const Failures before(mesh);
    runLoop(mesh, LoopSpec());
    ASSERT_EQ(faultOf(mesh), "") << i;
    EXPECT_LE(sumOfCosts(mesh), cost * (1 + 1e-12));
    EXPECT_LE(Failures(mesh).failing, before.failing);
    EXPECT_NEAR(volumeOf(mesh), volumeBehindWalls(mesh), 1e-11);
  }
  EXPECT_GT(count, int(repeats(30)));
}

TEST(EditLoop, KnowsWhetherACellThatItRemovedFailed)
{
  for (const bool fails : { false, true })
  {
    MeshEditor mesh = meshOfBoxes(blockOfBoxes(3, 1, 1));
    mesh.rawFace(faceBetween(mesh, 1, 2)).fails = fails ? 1 : 0;
    const MeshEditor::Mark mark = mesh.mark();
    EXPECT_FALSE(wasRefused(mesh, 2)); // it is still there
    ASSERT_TRUE(removeCell(mesh, 2));
    EXPECT_EQ(wasRefused(mesh, 2), fails);
    mesh.undo(mark);
  }
}

TEST(EditLoop, LeavesCubesAlone)
{
  MeshEditor mesh = meshOfBoxes(blockOfBoxes(3, 3, 3));
  const MeshEditor before = copyOf(mesh);
  runLoop(mesh, LoopSpec());
  EXPECT_EQ(differenceOf(mesh, before), "");
}

TEST(EditLoop, NodesStayOnTheSurface)
{
  for (const Step step : Steps)
  {
    for (unsigned seed = 0; seed < repeats(6); ++seed)
    {
      MeshEditor mesh = movedBlock(seed, 0.4);
      step(mesh);
      EXPECT_EQ(faultOf(mesh), "");
      expectFlatWalls(mesh);
      EXPECT_NEAR(volumeBehindWalls(mesh), 48, 1e-9);
    }
  }
}

// ... and, where they are held, exactly on their planes.
TEST(EditLoop, HeldNodesStayOnTheirPlanes)
{
  for (const Step step : Steps)
  {
    for (unsigned seed = 0; seed < repeats(6); ++seed)
    {
      MeshEditor mesh = movedBlock(seed, 0.4, 7);
      const MeshEditor before = copyOf(mesh);
      step(mesh);
      EXPECT_EQ(faultOf(mesh), "");
      for (std::uint32_t n = 0; n < before.nodeCount(); ++n)
      {
        for (std::size_t axis = 0; axis < 3 && !mesh.node(n).gone; ++axis)
        {
          if ((before.node(n).constrainedAxes >> axis & 1) != 0)
          {
            EXPECT_EQ(mesh.node(n).at[axis], before.node(n).at[axis]);
          }
        }
      }
      for (std::uint32_t f = 0; f < mesh.faceCount(); ++f)
      {
        const EditFace& face = mesh.face(f);
        for (std::size_t i = 0; !face.gone && mesh.isWall(f) && i < face.corners.size; ++i)
        {
          const auto axis = static_cast<std::size_t>(face.wall / 2);
          const double plane = face.wall % 2 == 0 ? 0 : axis == 2 ? 3 : 4;
          EXPECT_EQ(mesh.corner(f, i)[axis], plane);
        }
      }
    }
  }
}

TEST(EditLoop, RepeatsItself)
{
  for (const Step step : Steps)
  {
    MeshEditor first = movedBlock(1, 0.45);
    MeshEditor second = copyOf(first);
    step(first);
    step(second);
    EXPECT_EQ(differenceOf(first, second), "");
  }
}

// All lengths twice as large: the same mesh, to the bit.
TEST(EditLoop, HasNoUnit)
{
  for (const Step step : Steps)
  {
    MeshEditor mesh = movedBlock(1, 0.45);
    MeshEditor large = copyOf(mesh);
    scaleBy(large, 8);
    step(mesh);
    step(large);
    ASSERT_EQ(mesh.nodeCount(), large.nodeCount());
    ASSERT_EQ(mesh.faceCount(), large.faceCount());
    for (std::uint32_t n = 0; n < mesh.nodeCount(); ++n)
    {
      EXPECT_EQ(scaled(mesh.node(n).at, 8), large.node(n).at);
    }
    for (std::uint32_t f = 0; f < mesh.faceCount(); ++f)
    {
      EXPECT_EQ(mesh.face(f).cost, large.face(f).cost);
    }
  }
}

// Elsewhere: the same mesh, but for roundings.
TEST(EditLoop, HasNoPlace)
{
  const Vector from{ 8, 16, -32 };
  for (unsigned seed = 0; seed < repeats(4); ++seed)
  {
    MeshEditor mesh = movedBlock(seed, 0.45);
    MeshEditor other = movedBlock(seed, 0.45, 0, from);
    improveWhole(mesh);
    improveWhole(other);
    EXPECT_NEAR(sumOfCosts(mesh), sumOfCosts(other), 1e-9);
    ASSERT_EQ(mesh.nodeCount(), other.nodeCount());
    for (std::uint32_t n = 0; n < mesh.nodeCount(); ++n)
    {
      ASSERT_EQ(mesh.node(n).gone, other.node(n).gone);
      EXPECT_TRUE(
        mesh.node(n).gone || norm(minus(other.node(n).at, plus(mesh.node(n).at, from))) < 1e-12);
    }
  }
}

// Mirrored: as good, and mostly the same; of edits that gain the same, numbers decide.
TEST(EditLoop, HasNoHand)
{
  int same = 0;
  for (unsigned seed = 0; seed < 8; ++seed)
  {
    MeshEditor mesh = movedBlock(seed, 0.45);
    MeshEditor mirrored = movedBlock(seed, 0.45, 0, {}, true);
    const double before = sumOfCosts(mesh);
    EXPECT_NEAR(sumOfCosts(mirrored), before, 1e-9);
    improveWhole(mesh);
    improveWhole(mirrored);
    EXPECT_NEAR(sumOfCosts(mesh), sumOfCosts(mirrored), 0.2 * before);
    same += std::abs(sumOfCosts(mesh) - sumOfCosts(mirrored)) < 1e-9 ? 1 : 0;
  }
  EXPECT_GE(same, 4);
}

}
