// What a rim loses where a node goes, the next one gives back.
#include "Editing/EdgeArea.h"
#include "Support/Turned.h"

#include <gtest/gtest.h>

namespace cartesian
{

namespace
{

// Three boxes in a row. Over the wall y = 0 the upper edge goes through (0, 1), (1, 1 + rise), (2, 1 + rise) and (3, 1): an
// area of 2 rises. Without one of the two nodes it has half the base, 3, by its height.
MeshEditor row(double rise, const Turn& turn = {})
{
  return turnedMesh(turn, blockOfBoxes(3, 1, 1), [&](const Vector& p) {
    const bool isUp = p[2] == 1 && (p[0] == 1 || p[0] == 2);
    return Vector{ p[0], p[1], isUp ? 1 + rise : p[2] };
  });
}

struct Rim
{
  MeshEditor mesh;
  Vector middle;     // where the two nodes become one
  std::uint32_t u;   // goes
  std::uint32_t v;   // stays
  std::int32_t wall; // y = 0

  explicit Rim(double rise, const Turn& turn = {})
    : mesh(row(rise, turn))
    , middle(turn({ 1.5, 0, 1 + rise }))
    , u(nodeAt(mesh, turn({ 2, 0, 1 + rise })))
    , v(nodeAt(mesh, turn({ 1, 0, 1 + rise })))
    , wall(static_cast<std::int32_t>(2 * ((1 + turn.axes) % 3)))
  {
  }

  double areaOfWall() const
  {
    double area = 0;
    for (std::uint32_t f = 0; f < mesh.faceCount(); ++f)
    {
      area += !mesh.face(f).gone && mesh.face(f).wall == wall ? norm(mesh.face(f).area) : 0;
    }
    return area;
  }
};

constexpr double Rounding = 1e-12; // places are whole levels: 2^-46

void expectNear(const Vector& p, const Vector& q)
{
  EXPECT_LT(norm(minus(p, q)), Rounding);
}

}

// 2 rises = 3 / 2 of the height: it is 4 / 3 of the rise. So where the edge bends outwards and inwards, and either way.
TEST(EdgeArea, IsGivenBackByTheNextNode)
{
  for (const Turn& turn : turns())
  {
    for (const double rise : { 0.125, 0.0625, -0.0625, -0.125 })
    {
      const Rim rim(rise, turn);
      ASSERT_NE(rim.u, None);
      ASSERT_NE(rim.v, None);
      const Vector expected = turn({ 1.5, 0, 1 + rise * 4 / 3 });
      expectNear(placeKeepingArea(rim.mesh, rim.u, rim.v, rim.middle), expected);
      expectNear(placeKeepingArea(rim.mesh, rim.v, rim.u, rim.middle), expected);
      EXPECT_NEAR(areaLost(rim.mesh, rim.u, rim.v, rim.middle), std::abs(rise) / 2, Rounding);
      EXPECT_NEAR(areaLost(rim.mesh, rim.u, rim.v, expected), 0, Rounding);
      // The other end of it, not its middle: as high, as far along as it was.
      expectNear(placeKeepingArea(rim.mesh, rim.u, rim.v, rim.mesh.node(rim.v).at),
        turn({ 1, 0, 1 + rise * 4 / 3 }));
    }
  }
}

TEST(EdgeArea, OfTheWallIsTheSameAfterwards)
{
  for (const double rise : { 0.125, -0.125 })
  {
    for (const bool isBalanced : { true, false })
    {
      Rim rim(rise);
      const double before = rim.areaOfWall();
      EXPECT_NEAR(before, 3 + 2 * rise, Rounding);
      const Vector to =
        isBalanced ? placeKeepingArea(rim.mesh, rim.u, rim.v, rim.middle) : rim.middle;
      ASSERT_TRUE(collapseEdge(rim.mesh, rim.u, rim.v, to));
      rim.mesh.commit();
      measureAgain(rim.mesh);
      EXPECT_EQ(faultOf(rim.mesh), "");
      EXPECT_NEAR(rim.areaOfWall(), isBalanced ? before : before - rise / 2, Rounding);
    }
  }
}

// Nothing is lost along a straight edge.
TEST(EdgeArea, OfStraightEdgesStays)
{
  const Rim rim(0);
  expectNear(placeKeepingArea(rim.mesh, rim.u, rim.v, rim.middle), rim.middle);
  EXPECT_NEAR(areaLost(rim.mesh, rim.u, rim.v, rim.middle), 0, Rounding);
}

// A third of the rise aside: more than a tenth of a box is too far.
TEST(EdgeArea, IsNotGivenBackFarAside)
{
  const Rim near(0.296875);
  EXPECT_NE(placeKeepingArea(near.mesh, near.u, near.v, near.middle), near.middle);
  const Rim far(0.3125);
  EXPECT_EQ(placeKeepingArea(far.mesh, far.u, far.v, far.middle), far.middle);
}

TEST(EdgeArea, IsNotOfCornersOtherEdgesAndFixedNodes)
{
  Rim rim(0.125);
  const MeshEditor& mesh = rim.mesh;
  const std::uint32_t corner = nodeAt(mesh, { 3, 0, 1 });
  const Vector there = mesh.node(corner).at;
  EXPECT_EQ(placeKeepingArea(mesh, rim.u, corner, there), there); // it ends there
  EXPECT_EQ(areaLost(mesh, rim.u, corner, there), 0);
  const std::uint32_t across = nodeAt(mesh, { 2, 1, 1.125 }); // on another edge
  EXPECT_EQ(placeKeepingArea(mesh, rim.u, across, rim.middle), rim.middle);
  EXPECT_EQ(areaLost(mesh, rim.u, across, rim.middle), 0);
  rim.mesh.rawNode(rim.v).constrainedAxes = AllAxes;
  EXPECT_EQ(placeKeepingArea(mesh, rim.u, rim.v, rim.middle), rim.middle);
}

}
