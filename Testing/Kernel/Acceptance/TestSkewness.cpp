// Skewness against what can be worked out by hand, and limits against the definition of the mesh's quality.
#include "Acceptance/CellFaults.h"
#include "Acceptance/Limits.h"
#include "Acceptance/Skewness.h"
#include "Quality/QualityMeasures.h"
#include "Support/CellShapes.h"

#include <gtest/gtest.h>

#include <random>

using namespace cartesian;

namespace
{

constexpr double Close = 1e-12;

// Of area 1, around the origin, across z.
struct Square
{
  std::array<Vector, 4> nodes{ { { -0.5, -0.5, 0 }, { 0.5, -0.5, 0 }, { 0.5, 0.5, 0 },
    { -0.5, 0.5, 0 } } };
  std::array<std::uint32_t, 4> corners{ 0, 1, 2, 3 };

  Ring ring() const { return { nodes.data(), corners.data(), 4 }; }
};

// Of the square between two unit cubes, the upper one of which is shifted.
FaceSkewness between(double shiftX, double shiftY)
{
  const Vector aside{ -shiftX / 2, -shiftY / 2, 0 }; // from half-way to the upper centre
  const double distance = norm(Vector{ shiftX, shiftY, 1 });
  return skewnessOf(Square().ring(), { 0, 0, 0 }, aside, ShareOfDistance * distance);
}

// A cube, and a sheared box of some height on its top: the two cells of a mesh, and their faces.
struct TwoCells
{
  TwoCells(double shift, double height)
    : lower(shearedBox(1, 1, 0, 1, 0, true))
    , upper(shearedBox(1, 1, 1, 1 + height, shift, true))
  {
    lower.isBoundary[Top] = 0;
    upper.isBoundary[0] = 0;
    std::vector<double> points;
    std::vector<Vector> places;
    CellFaces cells;
    for (const Polyhedron* cell : { &lower, &upper })
    {
      cells.firstFace.push_back(cells.firstCorner.size());
      for (std::size_t f = 0; f < cell->faces(); ++f)
      {
        cells.firstCorner.push_back(cells.corners.size());
        for (std::uint32_t i = cell->start[f]; i < cell->start[f + 1]; ++i)
        {
          const Vector& at = cell->nodes[cell->corners[i]];
          const auto known = std::find(places.begin(), places.end(), at);
          cells.corners.push_back(static_cast<std::uint32_t>(known - places.begin()));
          if (known == places.end())
          {
            places.push_back(at);
            points.insert(points.end(), at.begin(), at.end());
          }
        }
      }
    }
    cells.firstFace.push_back(cells.firstCorner.size());
    cells.firstCorner.push_back(cells.corners.size());
    Execution execution;
    list = listFaces(cells, places.size(), Clashes::Refused, execution);
    quality = measureQuality(points.data(), cells, list, execution);
  }

  // The first is the only inner one.
  bool fails(std::size_t face, Measure measure) const
  {
    return (quality.faceFailures[face] >> measure & 1) != 0;
  }

  // In the mesh's list: boundary faces by cell and face.
  static constexpr std::size_t TopOfUpper = 1 + 5;
  static constexpr std::size_t Top = 1;

  Polyhedron lower;
  Polyhedron upper;
  FaceList list;
  Quality quality;
};

CellFaults faultsAt(const Polyhedron& cell, std::size_t face, const NeighbourCell& beyond)
{
  std::vector<NeighbourCell> all(cell.faces());
  std::vector<std::uint8_t> counted(cell.faces());
  all[face] = beyond;
  counted[face] = 1;
  return faultsOf(cell, shapeOf(cell), all, counted);
}

}

TEST(Skewness, OfASquareBetweenCubesIsTheShift)
{
  EXPECT_EQ(between(0, 0).value(), 0);
  for (const double shift : { 0.1, 0.5, 1.0, 2.0 })
  {
    EXPECT_NEAR(between(shift, 0).value(), shift, Close); // half of it, over half an edge
    EXPECT_NEAR(between(0, -shift).value(), shift, Close);
    EXPECT_NEAR(between(shift / 2, shift / 2).value(), shift / 2, Close); // over half a diagonal
    EXPECT_NEAR(between(shift, 0).reachAlone(), 0.5, Close);
  }
}

TEST(Skewness, IsMeasuredOverAPartOfTheDistanceAtLeast)
{
  EXPECT_NEAR(between(3, 0).value(), 1.5 / (0.2 * std::sqrt(10)), Close);
  EXPECT_NEAR(between(3, 0).reachAlone(), 0.2 * std::sqrt(10), Close);
}

TEST(Skewness, HasNoUnit)
{
  const Square square;
  std::array<Vector, 4> nodes = square.nodes;
  for (Vector& node : nodes)
  {
    node = scaled(node, 1e-9);
  }
  const double ofSmall =
    skewnessOf({ nodes.data(), square.corners.data(), 4 }, { 0, 0, 0 }, { 4e-10, 1e-10, 0 }, 1e-10)
      .value();
  EXPECT_NEAR(ofSmall, skewnessOf(square.ring(), { 0, 0, 0 }, { 0.4, 0.1, 0 }, 0.1).value(), Close);
}

TEST(Skewness, IsBeyondALimitWhereItsValueIs)
{
  std::mt19937 random(7);
  std::uniform_real_distribution<double> part(-1, 1);
  int beyond = 0;
  for (int i = 0; i < 1000; ++i)
  {
    const Vector aside{ part(random), part(random), 0 };
    const double least = std::abs(part(random));
    const double limit = 2 + part(random);
    const double value = skewnessOf(Square().ring(), { 0, 0, 0 }, aside, least).value();
    EXPECT_EQ(isSkewed(Square().ring(), { 0, 0, 0 }, aside, least, limit), value > limit);
    beyond += value > limit ? 1 : 0;
  }
  EXPECT_GT(beyond, 50);
  EXPECT_LT(beyond, 950);
}

// The four figures that have one limit in both are those of a mesh of these two cells; the angles of section 3 are
// asked for a sixth of a degree earlier.
TEST(Limits, AreThoseOfTheMeshsQuality)
{
  std::mt19937 random(5);
  std::uniform_real_distribution<double> exponent(-2.5, 2.5);
  std::array<int, 5> failing{};
  for (int i = 0; i < 500; ++i)
  {
    const TwoCells mesh(std::pow(10, exponent(random)), std::pow(10, exponent(random)));
    const CellFaults faults = faultsAt(mesh.lower, TwoCells::Top, asNeighbour(mesh.upper));
    const CellFaults atBoundary = faultsAt(mesh.upper, TwoCells::Top, {});
    const std::array<std::pair<Measure, int>, 4> measures{
      { { NonOrthogonality, faults.counts[CellFaults::NonOrthogonal] },
        { Skewness, faults.counts[CellFaults::InnerSkewness] },
        { FaceWeight, faults.counts[CellFaults::FaceWeight] },
        { VolumeRatio, faults.counts[CellFaults::VolumeRatio] } }
    };
    for (std::size_t m = 0; m < measures.size(); ++m)
    {
      EXPECT_EQ(measures[m].second, mesh.fails(0, measures[m].first) ? 1 : 0)
        << MeasureSpecs[measures[m].first].name;
      failing[m] += measures[m].second;
    }
    EXPECT_GE(faults.counts[CellFaults::InnerAngle], mesh.fails(0, InnerAngle) ? 1 : 0);
    EXPECT_EQ(atBoundary.counts[CellFaults::BoundarySkewness],
      mesh.fails(TwoCells::TopOfUpper, Skewness) ? 1 : 0);
    failing[4] += atBoundary.counts[CellFaults::BoundarySkewness];
  }
  for (const int count : failing)
  {
    EXPECT_GT(count, 10);
    EXPECT_LT(count, 490);
  }
}

// ... and the value is the same as the mesh's, but for rounding.
TEST(Limits, SkewnessHasOneDefinition)
{
  for (const double shift : { 0.0, 0.3, 1.0, 7.0, 40.0 })
  {
    for (const double height : { 0.05, 1.0, 3.0 })
    {
      const TwoCells mesh(shift, height);
      const Vector between = minus(asNeighbour(mesh.upper).centre, { 0.5, 0.5, 0.5 });
      const Vector aside{ -between[0] * 0.5 / between[2], 0, 0 };
      const double value = skewnessOf(
        ringOf(mesh.lower, TwoCells::Top), { 0.5, 0.5, 1 }, aside, ShareOfDistance * norm(between))
                             .value();
      EXPECT_NEAR(mesh.quality.faces[Skewness][0], value, 1e-12 * (1 + value));
    }
  }
}

TEST(Limits, AnglesFailJustBeforeSection3Does)
{
  const auto atDegrees =
    [](double degrees) { // of an inner face of a unit cube, as the cell beyond sees it
      return NeighbourCell{
        { 0.5 + std::sin(radians(degrees)), 0.5, 1 + std::cos(radians(degrees)) }, 1
      };
    };
  const Polyhedron cube = boxOf(1, 1, 1, false);
  EXPECT_EQ(faultsAt(cube, 1, atDegrees(74.8)).counts[CellFaults::InnerAngle], 0);
  EXPECT_EQ(faultsAt(cube, 1, atDegrees(74.9)).counts[CellFaults::InnerAngle], 1);
  EXPECT_FALSE(fails(InnerAngle, 74.9));
  EXPECT_TRUE(fails(InnerAngle, Limits::InnerAngle));
  EXPECT_EQ(faultsAt(cube, 1, atDegrees(89)).counts[CellFaults::WronglyOriented], 0);
  EXPECT_EQ(faultsAt(cube, 1, atDegrees(91)).counts[CellFaults::WronglyOriented], 1);
  EXPECT_FALSE(fails(BoundaryAngle, 89.9));
  EXPECT_TRUE(fails(BoundaryAngle, Limits::BoundaryAngle));
}
