// Measures of single cells and of few, against what can be worked out by hand.
#include "Quality/CorrectionGain.h"
#include "Quality/QualityMeasures.h"

#include <gtest/gtest.h>

#include <cmath>
#include <map>

using namespace cartesian;

namespace
{

constexpr double Close = 1e-12;
constexpr double Degrees = 180 / Pi;

using Polygon = std::vector<Vector>;
using Polyhedron = std::vector<Polygon>; // outward faces

struct Measured
{
  std::vector<double> points;
  CellFaces cells;
  FaceList faces;
  Quality quality;
  std::map<std::string, double> summary;

  double operator()(Measure measure, std::size_t cell) const
  {
    return quality.cells[measure][cell];
  }
};

// Points at the same place are one.
Measured measure(const std::vector<Polyhedron>& cells, int threads = 1)
{
  std::map<Vector, std::uint32_t> numbers;
  std::vector<double> points;
  CellFaces cellFaces;
  for (const Polyhedron& cell : cells)
  {
    cellFaces.firstFace.push_back(cellFaces.firstCorner.size());
    for (const Polygon& face : cell)
    {
      cellFaces.firstCorner.push_back(cellFaces.corners.size());
      for (const Vector& corner : face)
      {
        const auto [place, isNew] =
          numbers.try_emplace(corner, static_cast<std::uint32_t>(numbers.size()));
        cellFaces.corners.push_back(place->second);
        if (isNew)
        {
          points.insert(points.end(), corner.begin(), corner.end());
        }
      }
    }
  }
  cellFaces.firstFace.push_back(cellFaces.firstCorner.size());
  cellFaces.firstCorner.push_back(cellFaces.corners.size());
  Execution execution(threads);
  Measured result;
  result.faces = listFaces(cellFaces, numbers.size(), Clashes::AreBoundary, execution);
  result.quality = measureQuality(points.data(), cellFaces, result.faces, execution);
  result.points = std::move(points);
  result.cells = std::move(cellFaces);
  for (const SummaryValue& entry : summarise(result.quality, result.faces))
  {
    result.summary[entry.name] = entry.value;
  }
  return result;
}

// A prism over a counter-clockwise polygon, its base and top first.
Polyhedron prism(const std::vector<std::array<double, 2>>& base, double height = 1)
{
  Polygon bottom;
  Polygon top;
  Polyhedron result(2);
  for (std::size_t i = 0; i < base.size(); ++i)
  {
    const auto& p = base[i];
    const auto& q = base[(i + 1) % base.size()];
    bottom.insert(bottom.begin(), { p[0], p[1], 0 });
    top.push_back({ p[0], p[1], height });
    result.push_back(
      { { p[0], p[1], 0 }, { q[0], q[1], 0 }, { q[0], q[1], height }, { p[0], p[1], height } });
  }
  result[0] = bottom;
  result[1] = top;
  return result;
}

Polyhedron cubeAt(double x, double y, double z)
{
  Polyhedron cube = prism({ { x, y }, { x + 1, y }, { x + 1, y + 1 }, { x, y + 1 } });
  for (Polygon& face : cube)
  {
    for (Vector& corner : face)
    {
      corner[2] += z;
    }
  }
  return cube;
}

std::vector<Polyhedron> cubes(int n)
{
  std::vector<Polyhedron> cells;
  for (int i = 0; i < n * n * n; ++i)
  {
    cells.push_back(cubeAt(i % n, i / n % n, i / n / n));
  }
  return cells;
}

// L-shaped, one wide, with legs of `length`.
Polyhedron corner(double length)
{
  return prism({ { 0, 0 }, { length, 0 }, { length, 1 }, { 1, 1 }, { 1, length }, { 0, length } });
}

TEST(QualityMeasures, AreTheSameWithoutSlowOnes)
{
  const Measured all = measure(cubes(2));
  Execution execution(1);
  const Quality few = measureQuality(
    all.points.data(), all.cells, all.faces, execution, standardLimits(), SlowMeasures);
  for (std::size_t m = 0; m < MeasureCount; ++m)
  {
    const bool isSlow = (SlowMeasures >> m & 1U) != 0;
    const RawVector<double> best(few.cells[m].size(), MeasureSpecs[m].best);
    EXPECT_EQ(few.cells[m], isSlow ? best : all.quality.cells[m]) << MeasureSpecs[m].name;
  }
}

TEST(CorrectionGain, IsNothingWhereFacesAreNormalToTheLinesBetweenCells)
{
  const Measured grid = measure(cubes(3));
  for (const double gain : correctionGains(grid.faces, grid.quality))
  {
    EXPECT_NEAR(gain, 0, Close);
  }
}

// Of a cube with a cube beside it, and one above that leans over by twice its height: the line to the latter is as far
// from the normal of the face as it is long, and the cube's gradient answers with a half of its value, across and along.
TEST(CorrectionGain, FollowsFromTheLineBetweenCells)
{
  Polyhedron leaning = cubeAt(0, 0, 1);
  for (Polygon& face : leaning)
  {
    for (Vector& corner : face)
    {
      corner[0] += 2 * (corner[2] - 1);
    }
  }
  const Measured cells = measure({ cubeAt(0, 0, 0), cubeAt(1, 0, 0), leaning });
  const std::vector<double> gains = correctionGains(cells.faces, cells.quality);
  const double length = 1.0 / 6;                                    // volume by area of a cube
  const double above = (length + 1 / (4 + 2 * std::sqrt(5.0))) / 2; // of the face between
  EXPECT_NEAR(gains[0], above / 4 / (above + length), Close);
  EXPECT_NEAR(gains[1], 0, Close);
  EXPECT_NEAR(gains[2], 0, Close);
}

TEST(QualityMeasures, ACubeAlone)
{
  const Measured cube = measure({ cubeAt(0, 0, 0) });
  EXPECT_NEAR(cube(Volume, 0), 1, Close);
  EXPECT_EQ(cube(Openness, 0), 0);
  EXPECT_EQ(cube(OpenEdges, 0), 0);
  EXPECT_NEAR(cube(BoundaryAngle, 0), 0, Close);
  EXPECT_EQ(cube(InnerAngle, 0), 0);
  EXPECT_NEAR(cube(StarTriangulation, 0), 1, Close);
  EXPECT_EQ(cube(NonOrthogonality, 0), 0);
  EXPECT_NEAR(cube(Skewness, 0), 0, Close);
  EXPECT_EQ(cube(FaceWeight, 0), 1);
  EXPECT_EQ(cube(VolumeRatio, 0), 1);
  EXPECT_EQ(cube(Determinant, 0), 0) << "no inner face";
  EXPECT_NEAR(cube(AspectRatio, 0), 1, Close);
  EXPECT_EQ(cube(Concavity, 0), 0);
  // Two right triangles of sides 1/2 and 1/2, in a sphere of radius sqrt(5)/4.
  const double regular = 8 / (9 * std::sqrt(3.0)) * std::pow(std::sqrt(5.0) / 4, 3);
  EXPECT_NEAR(cube(TetQuality, 0), 1.0 / 24 / regular, Close);
  EXPECT_EQ(cube.quality.cellFailures[0], 1u << Determinant);
}

TEST(QualityMeasures, CubesInAGrid)
{
  const Measured grid = measure(cubes(3));
  for (std::size_t c = 0; c < 27; ++c)
  {
    const auto onSide = [](std::size_t i) { return i % 3 != 1; };
    const int sides = onSide(c) + onSide(c / 3) + onSide(c / 9);
    EXPECT_NEAR(grid(Determinant, c), std::pow(0.5, sides), Close);
    EXPECT_NEAR(grid(FaceWeight, c), 0.5, Close);
    EXPECT_NEAR(grid(VolumeRatio, c), 1, Close);
    EXPECT_NEAR(grid(InnerAngle, c), 0, 1e-5);
    EXPECT_NEAR(grid(NonOrthogonality, c), 0, 1e-5);
    EXPECT_EQ(grid(Concavity, c), 0);
    EXPECT_EQ(grid.quality.cellFailures[c], 0u);
  }
  EXPECT_EQ(grid.faces.neighbour.size(), 54u);
  EXPECT_EQ(grid.faces.owner.size(), 54u + 54u);
  EXPECT_EQ(grid.summary.at("Cells"), 27);
  EXPECT_EQ(grid.summary.at("FailingCells"), 0);
  EXPECT_NEAR(grid.summary.at("TotalVolume"), 27, Close);
  EXPECT_NEAR(grid.summary.at("BoundaryArea"), 54, Close);
}

TEST(QualityMeasures, ShearedCubesAreNotOrthogonal)
{
  const double slope = std::tan(30 / Degrees);
  const auto sheared = [&](double x) {
    return prism({ { x, slope * x }, { x + 1, slope * (x + 1) }, { x + 1, slope * (x + 1) + 1 },
      { x, slope * x + 1 } });
  };
  const Measured mesh = measure({ sheared(0), sheared(1) });
  EXPECT_NEAR(mesh(NonOrthogonality, 0), 30, 1e-9);
  EXPECT_NEAR(mesh(InnerAngle, 0), 30, 1e-9);
  EXPECT_NEAR(mesh.quality.faces[Skewness][0], 0, Close) << "through the face's centre";
  EXPECT_NEAR(mesh(FaceWeight, 1), 0.5, Close);
}

// A block of 2 x 2 x 1 beside cubes, with or without the corners of theirs on its other sides.
Polyhedron blockBesideCubes(bool hanging)
{
  Polyhedron block = hanging ? prism({ { -2, 0 }, { 0, 0 }, { 0, 1 }, { 0, 2 }, { -2, 2 } })
                             : prism({ { -2, 0 }, { 0, 0 }, { 0, 2 }, { -2, 2 } });
  if (!hanging)
  {
    block.erase(block.begin() + 3);
    block.push_back({ { 0, 0, 0 }, { 0, 1, 0 }, { 0, 1, 1 }, { 0, 0, 1 } });
    block.push_back({ { 0, 1, 0 }, { 0, 2, 0 }, { 0, 2, 1 }, { 0, 1, 1 } });
  }
  return block;
}

TEST(QualityMeasures, AFinerNeighbour)
{
  const Measured mesh = measure({ blockBesideCubes(true), cubeAt(0, 0, 0), cubeAt(0, 1, 0) });
  ASSERT_EQ(mesh.faces.neighbour.size(), 3u);
  EXPECT_EQ(mesh(OpenEdges, 0), 0);
  EXPECT_EQ(mesh(Concavity, 0), 0) << "sub-faces of one plane are not concave";
  EXPECT_NEAR(mesh(NonOrthogonality, 0), Degrees * std::atan(0.5 / 1.5), 1e-9);
  EXPECT_NEAR(mesh(InnerAngle, 0), Degrees * std::atan(0.5), 1e-9);
  EXPECT_NEAR(mesh(InnerAngle, 1), 0, 1e-5) << "seen from its own centre";
  EXPECT_NEAR(mesh.quality.faces[InnerAngle][0], Degrees * std::atan(0.5), 1e-9);
  EXPECT_NEAR(mesh(FaceWeight, 1), 1.0 / 3, Close);
  EXPECT_NEAR(mesh(VolumeRatio, 1), 1.0 / 4, Close);
  // The line from (-1, 1) to (0.5, 0.5) crosses x = 0 at 2/3: 1/6 from the centre, by 1/2.
  EXPECT_NEAR(mesh(Skewness, 1), 1.0 / 3, Close);
}

TEST(QualityMeasures, HangingNodesThatAreMissingLeaveGaps)
{
  const Measured mesh = measure({ blockBesideCubes(false), cubeAt(0, 0, 0), cubeAt(0, 1, 0) });
  EXPECT_EQ(mesh(OpenEdges, 0), 6) << "a long edge and two halves, above and below";
  EXPECT_EQ(mesh(OpenEdges, 1), 0);
  EXPECT_NEAR(mesh(Openness, 0), 0, Close) << "the area vectors know nothing of it";
  EXPECT_NE(mesh.quality.cellFailures[0] & 1u << OpenEdges, 0u);
}

TEST(QualityMeasures, ConcaveCells)
{
  const Measured small = measure({ corner(2) });
  EXPECT_NEAR(small(Volume, 0), 3, Close);
  EXPECT_NEAR(small(Concavity, 0), 90, 1e-9);
  // From (5/6, 5/6) to (1, 3/2), normal x.
  EXPECT_NEAR(small(BoundaryAngle, 0), Degrees * std::atan(4), 1e-9);
  EXPECT_NEAR(small(StarTriangulation, 0), 0, Close) << "the mean is the concave corner";
  EXPECT_EQ(small.quality.cellFailures[0] & (1u << BoundaryAngle | 1u << StarTriangulation), 0u);

  const Measured large = measure({ corner(4) });
  EXPECT_NEAR(large(StarTriangulation, 0), -6.0 / 7, Close);
  EXPECT_LT(large(TetQuality, 0), 0);
  EXPECT_NE(large.quality.cellFailures[0] & 1u << StarTriangulation, 0u);
}

TEST(QualityMeasures, AConcaveCellOfConvexFaces)
{
  Polyhedron legs = prism({ { 0, 0 }, { 4, 0 }, { 4, 1 }, { 1, 1 }, { 1, 4 }, { 0, 4 }, { 0, 1 } });
  const Polyhedron low = prism({ { 0, 0 }, { 4, 0 }, { 4, 1 }, { 1, 1 }, { 0, 1 } });
  const Polyhedron high = prism({ { 0, 1 }, { 1, 1 }, { 1, 4 }, { 0, 4 } });
  legs.erase(legs.begin(), legs.begin() + 2);
  legs.insert(legs.end(), { low[0], low[1], high[0], high[1] });
  const Measured mesh = measure({ legs });
  EXPECT_NEAR(mesh(Volume, 0), 7, 1e-11);
  EXPECT_EQ(mesh(OpenEdges, 0), 0);
  // From (19/14, 19/14) to (1, 5/2), normal x.
  EXPECT_NEAR(mesh(BoundaryAngle, 0), 90 + Degrees * std::atan(5.0 / 16), 1e-9);
  EXPECT_NEAR(mesh(Concavity, 0), 90, 1e-9) << "not between the parts of the base";
  EXPECT_EQ(
    mesh.quality.cellFailures[0], 1u << BoundaryAngle | 1u << TetQuality | 1u << Determinant);
  EXPECT_EQ(mesh.summary.at("ConcaveCells"), 1);
  EXPECT_EQ(mesh.summary.at("BoundaryAngleFailures"), 1);
}

TEST(QualityMeasures, ASlightBend)
{
  const double dent = std::tan(5 / Degrees);
  const Measured mesh = measure({ prism({ { 0, 0 }, { 1, dent }, { 2, 0 }, { 2, 2 }, { 0, 2 } }) });
  EXPECT_NEAR(mesh(Concavity, 0), 10, 1e-9);
  EXPECT_EQ(mesh.summary.at("ConcaveCells"), 1);
  EXPECT_EQ(mesh.quality.cellFailures[0], 1u << Determinant) << "concavity is no failure";
}

// A low roof whose two sides are one face: its area vector points straight up, and the cell has no
// area across y but for what cancels.
TEST(QualityMeasures, AWarpedFaceThatIsAWholeSide)
{
  const Vector a{ 0, 0, 0 };
  const Vector b{ 3, 0, 0 };
  const Vector c{ 3, 0.2, 0.1 };
  const Vector d{ 3, 0.4, 0 };
  const Vector e{ 0, 0.4, 0 };
  const Vector f{ 0, 0.2, 0.1 };
  const Measured mesh =
    measure({ { { a, e, d, b }, { b, d, c }, { e, a, f }, { a, b, c, d, e, f } } });
  EXPECT_EQ(mesh(Openness, 0), 0);
  EXPECT_EQ(mesh(OpenEdges, 0), 0);
  EXPECT_EQ(mesh(Concavity, 0), 0);
  EXPECT_GT(mesh(AspectRatio, 0), 1e9) << "as OpenFOAM has it";
}

TEST(QualityMeasures, CubesThatShareAnEdgeAreOneConvexCell)
{
  Polyhedron both = cubeAt(0, 0, 0);
  for (const Polygon& face : cubeAt(1, 1, 0))
  {
    both.push_back(face);
  }
  const Measured mesh = measure({ both });
  EXPECT_EQ(mesh(OpenEdges, 0), 0);
  EXPECT_EQ(mesh(Concavity, 0), 0);
}

TEST(QualityMeasures, ACubeWithoutItsTop)
{
  Polyhedron open = cubeAt(0, 0, 0);
  open.erase(open.begin() + 1);
  const Measured mesh = measure({ open });
  EXPECT_EQ(mesh(Openness, 0), 1);
  EXPECT_EQ(mesh(OpenEdges, 0), 4);
  EXPECT_NE(mesh.quality.cellFailures[0] & 1u << Openness, 0u);
  EXPECT_EQ(mesh.summary.at("OpennessFailures"), 1);
}

TEST(QualityMeasures, ACubeInsideOut)
{
  Polyhedron cube = cubeAt(0, 0, 0);
  for (Polygon& face : cube)
  {
    std::reverse(face.begin(), face.end());
  }
  const Measured mesh = measure({ cube, cubeAt(1, 0, 0) });
  EXPECT_NEAR(mesh(Volume, 0), -1, Close);
  EXPECT_NEAR(mesh(BoundaryAngle, 0), 180, 1e-9);
  EXPECT_EQ(mesh.faces.neighbour.size(), 0u) << "its faces turn the wrong way";
  EXPECT_EQ(mesh.quality.cellFailures[1], 1u << Determinant);
  EXPECT_EQ(mesh.summary.at("VolumeFailures"), 1);
  EXPECT_NEAR(mesh.summary.at("MinVolume"), -1, Close);
}

TEST(QualityMeasures, CellsWithoutExtent)
{
  Polyhedron flat = prism({ { 0, 0 }, { 1, 0 }, { 1, 1 }, { 0, 1 } }, 0);
  Polyhedron point(4, Polygon(3, Vector{ 2, 2, 2 }));
  const Measured mesh = measure({ flat, point });
  for (std::size_t c = 0; c < 2; ++c)
  {
    EXPECT_EQ(mesh(Volume, c), 0);
    EXPECT_NE(mesh.quality.cellFailures[c] & 1u << Volume, 0u);
    EXPECT_NE(mesh.quality.cellFailures[c] & 1u << TetQuality, 0u);
    for (std::size_t m = 0; m < MeasureCount; ++m)
    {
      EXPECT_FALSE(std::isnan(mesh.quality.cells[m][c])) << MeasureSpecs[m].name;
    }
  }
}

TEST(QualityMeasures, NoCells)
{
  const Measured mesh = measure({});
  EXPECT_EQ(mesh.summary.at("Cells"), 0);
  EXPECT_EQ(mesh.summary.at("FailingCells"), 0);
  EXPECT_EQ(mesh.summary.at("MaxSkewness"), 0);
}

TEST(QualityMeasures, CellsWithoutFacesAreNotMeasured)
{
  const Measured mesh = measure({ cubeAt(0, 0, 0), {}, cubeAt(1, 0, 0) });
  EXPECT_TRUE(std::isnan(mesh(Volume, 1)));
  EXPECT_TRUE(std::isnan(mesh(Skewness, 1)));
  EXPECT_EQ(mesh.quality.cellFailures[1], 0u);
  EXPECT_NEAR(mesh.summary.at("MinVolume"), 1, Close);
  EXPECT_NEAR(mesh.summary.at("TotalVolume"), 2, Close);
}

TEST(QualityMeasures, CellsThatAreLeftOutDoNotCount)
{
  Polyhedron open = cubeAt(1, 0, 0);
  open.erase(open.begin() + 1); // its top
  const Measured mesh = measure({ cubeAt(0, 0, 0), open });
  const std::array<unsigned char, 2> leftOut{ 0, 1 };
  std::map<std::string, double> summary;
  for (const SummaryValue& entry : summarise(mesh.quality, mesh.faces, leftOut.data()))
  {
    summary[entry.name] = entry.value;
  }
  EXPECT_EQ(mesh.summary.at("OpenEdgesFailures"), 1);
  EXPECT_EQ(summary.at("OpenEdgesFailures"), 0);
  EXPECT_EQ(summary.at("MaxOpenness"), 0);
  EXPECT_EQ(summary.at("Cells"), 1);
  EXPECT_NEAR(summary.at("TotalVolume"), 1, Close);
  EXPECT_NEAR(mesh.summary.at("BoundaryArea"), 5 + 4, Close);
  EXPECT_NEAR(summary.at("BoundaryArea"), 5, Close);
}

TEST(QualityMeasures, LimitsThemselvesFail)
{
  const double none = std::numeric_limits<double>::quiet_NaN();
  EXPECT_TRUE(fails(BoundaryAngle, 90));
  EXPECT_FALSE(fails(BoundaryAngle, 89.999));
  EXPECT_TRUE(fails(InnerAngle, 75));
  EXPECT_TRUE(fails(Volume, 0));
  EXPECT_FALSE(fails(Volume, 1e-200));
  EXPECT_TRUE(fails(FaceWeight, 0.05));
  EXPECT_TRUE(fails(Skewness, none));
  EXPECT_TRUE(fails(Volume, none));
  EXPECT_FALSE(fails(Concavity, 180));
}

TEST(QualityMeasures, ThreadsDoNotMatter)
{
  const std::vector<Polyhedron> cells = cubes(12); // several chunks
  const Measured one = measure(cells, 1);
  const Measured three = measure(cells, 3);
  EXPECT_EQ(one.faces.face, three.faces.face);
  EXPECT_EQ(one.faces.owner, three.faces.owner);
  EXPECT_EQ(one.faces.neighbour, three.faces.neighbour);
  EXPECT_EQ(one.quality.cells, three.quality.cells);
  EXPECT_EQ(one.quality.faces, three.quality.faces);
}

}
