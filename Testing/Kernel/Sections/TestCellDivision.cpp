// Polyhedra divided: conforming, of the same volume, linear fields exact.
#include "Sections/CellDivision.h"
#include "Sections/StarPoint.h"
#include "Support/CellFacesOf.h"

#include <random>

using namespace cartesian;

namespace
{

FacedCells meshed(const NamedShape& shape)
{
  return facedCells(meshOf(shape.soup, cellsAlongLongest(shape.soup, 9), TestOptions()).mesh);
}

double volumeOf(const FacedCells& mesh, std::size_t cell)
{
  std::vector<FaceGeometry> faces;
  return FaceCorners(mesh.cells, mesh.points.data()).geometryOfCell(cell, faces).volume;
}

double tetrahedron(const Vector& a, const Vector& b, const Vector& c, const Vector& top)
{
  return dot(cross(minus(b, a), minus(c, a)), minus(a, top)) / 6;
}

// The least part, and the sum of all.
std::pair<double, double> parts(
  const FacedCells& mesh, const CellDivision& division, std::size_t cell)
{
  const FaceCorners corners(mesh.cells, mesh.points.data());
  const Vector& top = division.centres[cell];
  double least = std::numeric_limits<double>::infinity();
  double sum = 0;
  for (std::size_t face = mesh.cells.firstFace[cell]; face < mesh.cells.firstFace[cell + 1]; ++face)
  {
    const std::uint32_t fan = division.fans.fanOf[face];
    const std::size_t size = corners.size(face);
    for (std::size_t i = 0; i < (fan == NoPoint ? size - 2 : size); ++i)
    {
      const double part = fan == NoPoint
        ? tetrahedron(
            corners.corner(face, 0), corners.corner(face, i + 1), corners.corner(face, i + 2), top)
        : tetrahedron(corners.corner(face, i), corners.corner(face, (i + 1) % size),
            division.fans.centres[fan], top);
      least = std::min(least, part);
      sum += part;
    }
  }
  return { least, sum };
}

Polyhedron prism(const std::vector<std::array<double, 2>>& base, double height)
{
  Polygon below;
  Polygon above;
  for (const auto& p : base)
  {
    below.insert(below.begin(), { p[0], p[1], 0 });
    above.push_back({ p[0], p[1], height });
  }
  Polyhedron cell{ below, above };
  for (std::size_t i = 0; i < base.size(); ++i)
  {
    const auto& p = base[i];
    const auto& q = base[(i + 1) % base.size()];
    cell.push_back(
      { { p[0], p[1], 0 }, { q[0], q[1], 0 }, { q[0], q[1], height }, { p[0], p[1], height } });
  }
  return cell;
}

}

class DivisionOf : public ::testing::TestWithParam<NamedShape>
{
};

TEST_P(DivisionOf, HasTheVolumesOfTheCells)
{
  const FacedCells mesh = meshed(GetParam());
  Execution execution;
  const CellDivision division = divideCells(mesh.cells, mesh.points.data(), execution);
  const double size = GetParam().soup.longest();
  for (std::size_t cell = 0; cell < mesh.cells.cellCount(); ++cell)
  {
    const double volume = volumeOf(mesh, cell);
    const auto [least, sum] = parts(mesh, division, cell);
    EXPECT_NEAR(sum, volume, 1e-12 * volume + mesh.rounding() * size * size);
    EXPECT_GT(least, division.inverts[cell] != 0 ? -volume : 0);
  }
}

TEST_P(DivisionOf, DividesAFaceTheSameFromBothCells)
{
  const FacedCells mesh = meshed(GetParam());
  Execution execution;
  const CellDivision division = divideCells(mesh.cells, mesh.points.data(), execution);
  const FaceList list = listFaces(mesh.cells, mesh.points.size() / 3, Clashes::Refused, execution);
  for (std::size_t i = 0; i < list.neighbour.size(); ++i)
  {
    const std::size_t other = faceBeyond(mesh.cells, list.face[i], list.neighbour[i]);
    EXPECT_EQ(division.fans.fanOf[list.face[i]], division.fans.fanOf[other]);
  }
}

TEST_P(DivisionOf, KeepsLinearFields)
{
  const FacedCells mesh = meshed(GetParam());
  Execution execution(2);
  const CellDivision division = divideCells(mesh.cells, mesh.points.data(), execution);
  const PointSums sums = sumsOf(division, mesh.cells, mesh.points.data(), execution);
  const double size = GetParam().soup.longest();
  for (std::size_t i = 0; i + 1 < sums.first.size(); ++i)
  {
    const Vector& known = i < division.fans.count() ? division.fans.centres[i]
                                                    : division.centres[i - division.fans.count()];
    Vector gap{};
    double weights = 0;
    for (std::size_t term = sums.first[i]; term < sums.first[i + 1]; ++term)
    {
      gap = plus(gap, scaled(minus(mesh.at(sums.point[term]), known), sums.weight[term]));
      weights += sums.weight[term];
    }
    EXPECT_NEAR(weights, 1, 1e-9);
    EXPECT_LT(norm(gap), 1e-9 * size + mesh.rounding());
  }
}

INSTANTIATE_TEST_SUITE_P(Of, DivisionOf, ::testing::ValuesIn(cleanShapes()), nameOf);

TEST(CellDivision, DoesNotDependOnThreads)
{
  const FacedCells mesh = meshed(cleanShapes().front());
  Execution one;
  Execution three(3);
  const CellDivision a = divideCells(mesh.cells, mesh.points.data(), one);
  const CellDivision b = divideCells(mesh.cells, mesh.points.data(), three);
  EXPECT_EQ(a.fans.fanOf, b.fans.fanOf);
  EXPECT_EQ(a.fans.centres, b.fans.centres);
  EXPECT_EQ(a.centres, b.centres);
}

TEST(CellDivision, AnElsCentreMovesToWhereItSeesAll)
{
  // Its centre is behind the inner corner; the point must be in the corner's square.
  const FacedCells mesh =
    facedCells({ prism({ { 0, 0 }, { 9, 0 }, { 9, 1 }, { 1, 1 }, { 1, 9 }, { 0, 9 } }, 1) });
  Execution execution;
  const CellDivision division = divideCells(mesh.cells, mesh.points.data(), execution);
  // The fans of its top and bottom are not star-shaped themselves.
  EXPECT_EQ(division.moved + division.inverts[0], 1u);
  const auto [least, sum] = parts(mesh, division, 0);
  EXPECT_NEAR(sum, 17, 1e-12);
}

TEST(CellDivision, FlatConvexQuadrilateralsStayWhole)
{
  const std::array<Vector, 4> square{ { { 0, 0, 0 }, { 1, 0, 0 }, { 1, 1, 0 }, { 0, 1, 0 } } };
  EXPECT_TRUE(staysWhole(square, { 0, 1, 2, 3 }));
  auto warped = square;
  warped[2][2] = 1e-9;
  EXPECT_FALSE(staysWhole(warped, { 0, 1, 2, 3 }));
  auto dart = square;
  dart[2] = { 0.2, 0.2, 0 };
  EXPECT_FALSE(staysWhole(dart, { 0, 1, 2, 3 }));
  auto triangle = square;
  triangle[2] = { 0.5, 0.5, 0 };
  EXPECT_FALSE(staysWhole(triangle, { 0, 1, 2, 3 }));
}

TEST(CellDivision, WhetherAQuadrilateralStaysWholeIsTheSameFromBothSides)
{
  std::mt19937 random(3);
  std::normal_distribution<double> normal;
  int whole = 0;
  for (int i = 0; i < 2000; ++i)
  {
    // Warped by about as much as is allowed.
    std::array<Vector, 4> corners{ { { 0, 0, 0 }, { 1, 0, 0 }, { 1, 1, 0 }, { 0, 1, 0 } } };
    std::array<std::uint32_t, 4> ids{ 7, 3, 9, 4 };
    for (Vector& corner : corners)
    {
      const double x = normal(random) * 0.1;
      const double y = normal(random) * 0.1;
      corner = { corner[0] + x, corner[1] + y, normal(random) * 1e-12 };
    }
    const bool stays = staysWhole(corners, ids);
    whole += stays ? 1 : 0;
    std::reverse(corners.begin(), corners.end());
    std::reverse(ids.begin(), ids.end());
    for (int turn = 0; turn < 4; ++turn)
    {
      std::rotate(corners.begin(), corners.begin() + 1, corners.end());
      std::rotate(ids.begin(), ids.begin() + 1, ids.end());
      EXPECT_EQ(staysWhole(corners, ids), stays);
    }
  }
  EXPECT_GT(whole, 100);
  EXPECT_LT(whole, 1900);
}

TEST(StarPoint, OfACubeIsItsCentre)
{
  std::vector<HalfSpace> spaces;
  for (std::size_t axis = 0; axis < 3; ++axis)
  {
    Vector out{};
    out[axis] = 1;
    spaces.push_back({ out, 2 });
    spaces.push_back({ scaled(out, -1), 0 });
  }
  const auto point = starPoint(spaces, { 0.3, 0.3, 0.3 }, 4);
  ASSERT_TRUE(point);
  EXPECT_LT(norm(minus(*point, { 1, 1, 1 })), 1e-12);
}

TEST(StarPoint, IsInsideWhereverHalfSpacesHaveACommonPart)
{
  std::mt19937 random(5);
  std::normal_distribution<double> normal;
  for (int round = 0; round < 300; ++round)
  {
    const Vector inside{ normal(random), normal(random), normal(random) };
    std::vector<HalfSpace> spaces;
    for (int i = 0; i < 30; ++i)
    {
      const double x = normal(random);
      const double y = normal(random);
      const Vector out = unit({ x, y, normal(random) });
      spaces.push_back({ out, dot(out, inside) + 1e-3 * std::abs(normal(random)) + 1e-6 });
    }
    const auto point = starPoint(spaces, { 0, 0, 0 }, 10);
    ASSERT_TRUE(point);
    for (const HalfSpace& space : spaces)
    {
      EXPECT_LT(dot(space.outward, *point), space.offset);
    }
  }
}

TEST(StarPoint, IsNoneWhereTheyHaveNone)
{
  EXPECT_FALSE(starPoint({ { { 1, 0, 0 }, 0 }, { { -1, 0, 0 }, -1e-3 } }, { 0, 0, 0 }, 1));
}
