// Single cells: measured, and cut by planes.
#include "Acceptance/CellFaults.h"
#include "Polyhedra/PolyhedronCut.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>

namespace cartesian
{

namespace
{

// A prism over a polygon (counter-clockwise, in x and y) from z = 0 to `height`; all its faces are
// boundary.
Polyhedron prism(const std::vector<std::array<double, 2>>& base, double height)
{
  Polyhedron cell;
  const auto n = static_cast<std::uint32_t>(base.size());
  for (const double z : { 0.0, height })
  {
    for (const auto& [x, y] : base)
    {
      cell.nodes.push_back({ x, y, z });
    }
  }
  for (std::uint32_t i = 0; i < n; ++i)
  {
    cell.addCorner(n - 1 - i);
  }
  cell.closeFace(true);
  for (std::uint32_t i = 0; i < n; ++i)
  {
    cell.addCorner(n + i);
  }
  cell.closeFace(true);
  for (std::uint32_t i = 0; i < n; ++i)
  {
    const std::uint32_t next = (i + 1) % n;
    for (const std::uint32_t corner : { i, next, n + next, n + i })
    {
      cell.addCorner(corner);
    }
    cell.closeFace(true);
  }
  return cell;
}

Polyhedron cube()
{
  return prism({ { 0, 0 }, { 1000, 0 }, { 1000, 1000 }, { 0, 1000 } }, 1000);
}

// The arms of an L are `arm` wide.
Polyhedron ell(double arm)
{
  return prism(
    { { 0, 0 }, { 1000, 0 }, { 1000, arm }, { arm, arm }, { arm, 1000 }, { 0, 1000 } }, 1000);
}

double volumeOf(const Polyhedron& cell)
{
  CellShape shape;
  measure(cell, shape);
  return shape.volume;
}

std::array<int, CellFaults::Kinds> faultsOf(const Polyhedron& cell)
{
  CellShape shape;
  measure(cell, shape);
  return faultsOf(cell, shape, std::vector<NeighbourCell>(cell.faces())).counts;
}

// Every edge is used as often in one direction as in the other.
bool isClosed(const Polyhedron& cell)
{
  std::vector<std::array<std::uint32_t, 2>> edges;
  std::vector<std::array<std::uint32_t, 2>> turned;
  for (std::size_t f = 0; f < cell.faces(); ++f)
  {
    for (std::uint32_t i = cell.start[f]; i < cell.start[f + 1]; ++i)
    {
      const std::uint32_t next = i + 1 < cell.start[f + 1] ? i + 1 : cell.start[f];
      edges.push_back({ cell.corners[i], cell.corners[next] });
      turned.push_back({ cell.corners[next], cell.corners[i] });
    }
  }
  std::sort(edges.begin(), edges.end());
  std::sort(turned.begin(), turned.end());
  return edges == turned;
}

}

// Projected centres are those of the faces flattened along their normals; flat faces have the same.
TEST(Polyhedron, ProjectedCentresAreThoseOfFlattenedFaces)
{
  Polyhedron bent = prism({ { 0, 0 }, { 1000, 0 }, { 900, 700 }, { 0, 1000 } }, 1000);
  bent.nodes[6][2] += 800; // of the upper face
  CellShape usual;
  CellShape projected;
  measure(bent, usual);
  measure(bent, projected);
  projectCentres(bent, projected);
  const std::size_t upper = 1;
  const Vector normal = unit(usual.faces[upper].area);
  Polyhedron flat = bent;
  for (std::size_t i = bent.start[upper]; i < bent.start[upper + 1]; ++i)
  {
    Vector& node = flat.nodes[bent.corners[i]];
    node = minus(node, scaled(normal, dot(minus(node, usual.faces[upper].mean), normal)));
  }
  CellShape flattened;
  measure(flat, flattened);
  const Vector off = minus(projected.faces[upper].centre, flattened.faces[upper].centre);
  EXPECT_LT(norm(cross(off, normal)), 1e-9);
  EXPECT_GT(norm(minus(projected.faces[upper].centre, usual.faces[upper].centre)), 1);
  EXPECT_GT(norm(minus(projected.centre, usual.centre)), 0.1);
  EXPECT_LT(norm(minus(projected.faces[0].centre, usual.faces[0].centre)), 1e-9);
}

TEST(Polyhedron, ACubeIsMeasured)
{
  CellShape shape;
  measure(cube(), shape);
  EXPECT_DOUBLE_EQ(shape.volume, 1e9);
  for (int axis = 0; axis < 3; ++axis)
  {
    EXPECT_DOUBLE_EQ(shape.centre[axis], 500);
  }
  for (std::size_t f = 0; f < 6; ++f)
  {
    EXPECT_FALSE(isAtFault(cube(), shape, f));
  }
}

TEST(Polyhedron, AThinEllFailsTheAngleConditionAndAThickOneDoesNot)
{
  // Seen from the concave corner, the centre of an L leaves it when its arms get thinner than 0.38.
  EXPECT_EQ(faultsOf(ell(300))[CellFaults::BoundaryAngle], 2);
  EXPECT_EQ(faultsOf(ell(600))[CellFaults::BoundaryAngle], 0);
}

TEST(Polyhedron, ANarrowFaceFarFromTheCentreIsSkewed)
{
  // The upper side of a slab in a wide face and a narrow one at its end.
  const Polyhedron slab =
    prism({ { 0, 0 }, { 1000, 0 }, { 1000, 100 }, { 990, 100 }, { 0, 100 } }, 1000);
  CellShape shape;
  measure(slab, shape);
  EXPECT_EQ(faultsOf(slab)[CellFaults::BoundaryAngle], 0);
  EXPECT_EQ(faultsOf(slab)[CellFaults::BoundarySkewness], 1);
  EXPECT_TRUE(isAtFault(slab, shape, 4));
  EXPECT_FALSE(isAtFault(slab, shape, 5));
}

TEST(PolyhedronCut, ACubeInHalves)
{
  CellCut cut;
  ASSERT_TRUE(cutCell(cube(), { { 500, 0, 0 }, { 1, 0, 0 }, {} }, cut));
  EXPECT_EQ(cut.parts, 2u);
  EXPECT_EQ(cut.points.size(), 4u);
  EXPECT_EQ(cut.faces.size(), 2u + 4 * 2 + 1); // two whole, four in two, one new
  for (std::uint32_t part = 0; part < 2; ++part)
  {
    const Polyhedron half = partOf(cube(), cut, part);
    EXPECT_EQ(half.faces(), 6u);
    EXPECT_TRUE(isClosed(half));
    EXPECT_DOUBLE_EQ(volumeOf(half), 5e8);
  }
}

TEST(PolyhedronCut, APlaneNearCornersTakesThem)
{
  // Within 3 degrees of a diagonal: no new node.
  CellCut cut;
  const double slope = std::tan(radians(45.0 + 3));
  const Vector normal = unit({ -slope, 1, 0 });
  ASSERT_TRUE(cutCell(cube(), { { 0, 0, 0 }, normal, {} }, cut));
  EXPECT_TRUE(cut.points.empty());
  EXPECT_DOUBLE_EQ(volumeOf(partOf(cube(), cut, 0)), 5e8);
  EXPECT_DOUBLE_EQ(volumeOf(partOf(cube(), cut, 1)), 5e8);
}

// The edges of the cutting polygon would turn by more than 5 degrees.
TEST(PolyhedronCut, APlaneFartherFromCornersLeavesThem)
{
  const double slope = std::tan(radians(45.0 + 6));
  CellCut cut;
  ASSERT_TRUE(cutCell(cube(), { { 0, 0, 0 }, unit({ -slope, 1, 0 }), {} }, cut));
  ASSERT_EQ(cut.points.size(), 2u);
  for (const CellCut::NewNode& node : cut.points)
  {
    EXPECT_NEAR(node.at[0], 1000 / slope, 1);
    EXPECT_EQ(node.at[1], 1000);
  }
  std::vector<double> volumes{ volumeOf(partOf(cube(), cut, 0)), volumeOf(partOf(cube(), cut, 1)) };
  std::sort(volumes.begin(), volumes.end());
  EXPECT_NEAR(volumes[0], 5e8 / slope, 1e6);
  EXPECT_NEAR(volumes[1], 1e9 - 5e8 / slope, 1e6);
}

TEST(PolyhedronCut, APlaneBesideTheCellCutsNothing)
{
  CellCut cut;
  EXPECT_FALSE(cutCell(cube(), { { 2000, 0, 0 }, { 1, 0, 0 }, {} }, cut));
  EXPECT_FALSE(cutCell(cube(), { { 1000, 0, 0 }, { 1, 0, 0 }, {} }, cut));
}

TEST(PolyhedronCut, AnEllAlongItsConcaveEdge)
{
  const Polyhedron cell = ell(300);
  CellCut cut;
  ASSERT_TRUE(cutCell(cell, { { 300, 300, 0 }, unit({ -1, 1, 0 }), { 3, 9 } }, cut));
  EXPECT_EQ(cut.parts, 2u);
  double volume = 0;
  CellShape shape;
  for (std::uint32_t part = 0; part < cut.parts; ++part)
  {
    const Polyhedron arm = partOf(cell, cut, part);
    EXPECT_TRUE(isClosed(arm));
    measure(arm, shape);
    EXPECT_EQ(faultsOf(arm)[CellFaults::BoundaryAngle], 0);
    volume += shape.volume;
  }
  EXPECT_DOUBLE_EQ(volume, volumeOf(cell));
}

// A surely accepted face is never refused, with the centres of either version of OpenFOAM.
TEST(Polyhedron, FacesThatAreSurelyAcceptedAreNotRefused)
{
  std::mt19937 random(17);
  std::uniform_real_distribution<double> uniform(-1, 1);
  const auto vector = [&](double size) {
    return Vector{ size * uniform(random), size * uniform(random), size * uniform(random) };
  };
  int sure = 0;
  int refused = 0;
  for (int trial = 0; trial < 200000; ++trial)
  {
    Polyhedron cell;
    const Vector u = vector(1000);
    const Vector v = vector(1000);
    for (const auto& [a, b] : { std::pair(-1, -1), std::pair(1, -1), std::pair(0, 1) })
    {
      cell.addCorner(static_cast<std::uint32_t>(cell.nodes.size()));
      cell.nodes.push_back(plus(scaled(u, a), scaled(v, b)));
    }
    cell.closeFace(false);
    CellShape shape;
    measure(cell, shape);
    const FaceShape& face = shape.faces[0];
    const Vector normal = unit(face.area);
    const double reach = std::pow(10, 2 + 1.5 * uniform(random));
    shape.centre = minus(plus(face.centre, vector(reach)), scaled(normal, reach));
    shape.volume = 1;
    const NeighbourCell beyond{ plus(plus(face.centre, vector(reach)), scaled(normal, reach)), 1 };
    const bool isSure = isSurelyAccepted(centreOffsetOf(shape.centre, face.centre, face.area),
      centreOffsetOf(beyond.centre, face.centre, scaled(face.area, -1)));
    const bool isBad = isRefused(cell, shape, 0, beyond);
    EXPECT_FALSE(isSure && isBad);
    sure += isSure ? 1 : 0;
    refused += isBad ? 1 : 0;
  }
  EXPECT_GT(sure, 10000);
  EXPECT_GT(refused, 10000);
}

TEST(PolyhedronCut, AForkFallsIntoThree)
{
  // A U lying on its side: a plane across both prongs.
  const Polyhedron fork = prism({ { 0, 0 }, { 1000, 0 }, { 1000, 300 }, { 300, 300 }, { 300, 700 },
                                  { 1000, 700 }, { 1000, 1000 }, { 0, 1000 } },
    1000);
  CellCut cut;
  ASSERT_TRUE(cutCell(fork, { { 600, 0, 0 }, { 1, 0, 0 }, {} }, cut));
  EXPECT_EQ(cut.parts, 3u);
  double volume = 0;
  for (std::uint32_t part = 0; part < cut.parts; ++part)
  {
    EXPECT_TRUE(isClosed(partOf(fork, cut, part)));
    volume += volumeOf(partOf(fork, cut, part));
  }
  EXPECT_DOUBLE_EQ(volume, volumeOf(fork));
}

}
