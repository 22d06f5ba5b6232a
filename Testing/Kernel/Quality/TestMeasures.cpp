// SPDX-License-Identifier: BSD-3-Clause
// Measures of faces and cells against what can be worked out by hand.
#include "Quality/CellMeasures.h"
#include "Quality/FaceMeasures.h"

#include <gtest/gtest.h>

using namespace cartesian;

namespace
{

// Of the square between two cubes with edges of `unit`, the upper one of which is shifted, in these units.
double skewnessBetween(double shiftX, double shiftY, double unit = 1)
{
  const std::array<Vector, 4> square{ { { -0.5, -0.5, 0 }, { 0.5, -0.5, 0 }, { 0.5, 0.5, 0 },
    { -0.5, 0.5, 0 } } };
  const Vector aside{ -shiftX / 2 * unit, -shiftY / 2 * unit,
    0 }; // from half-way to the upper centre
  const double distance = norm(Vector{ shiftX, shiftY, 1 }) * unit;
  return skewness(
    4, [&](std::size_t i) { return scaled(square[i], unit); }, Vector{}, aside,
    ShareOfDistance * distance);
}

void expectSkewness(double shiftX, double shiftY, double value)
{
  for (const double unit : { 1.0, 1e-9, 1e6 })
  {
    EXPECT_NEAR(skewnessBetween(shiftX, shiftY, unit), value, 1e-12) << shiftX << " " << shiftY;
  }
}

// Of a box with edges along the axes: outward, low before high.
std::array<Vector, 6> areasOfBox(double x, double y, double z)
{
  return { { { -y * z, 0, 0 }, { y * z, 0, 0 }, { 0, -z * x, 0 }, { 0, z * x, 0 }, { 0, 0, -x * y },
    { 0, 0, x * y } } };
}

template <class Sums>
Sums sumsOfBox(double x, double y, double z)
{
  Sums sums;
  for (const Vector& area : areasOfBox(x, y, z))
  {
    sums.add(area);
  }
  return sums;
}

}

TEST(Skewness, OfASquareBetweenCubesIsTheShift)
{
  EXPECT_EQ(skewnessBetween(0, 0), 0);
  for (const double shift : { 0.1, 0.5, 1.0, 2.0 })
  {
    expectSkewness(shift, 0, shift); // half of it, over half an edge
    expectSkewness(0, -shift, shift);
    expectSkewness(shift / 2, shift / 2, shift / 2); // over half a diagonal
  }
}

TEST(Skewness, IsMeasuredOverAPartOfTheDistanceAtLeast)
{
  expectSkewness(3, 0, 1.5 / (0.2 * std::sqrt(10)));
}

TEST(FaceMeasures, OfAFaceWithoutAreaAreTheWorst)
{
  const auto onALine = [](std::size_t i) { return Vector{ double(i), 0, 0 }; };
  EXPECT_EQ(measuresOfFace(5, onALine).star, -1);
  EXPECT_EQ(measuresOfFace(5, onALine).warp, 1);
}

// A square of which one corner is lifted by its edge: four triangles of equal moment around the mean.
TEST(FaceMeasures, OfAWarpedSquare)
{
  const std::array<Vector, 4> corners{ { { 0, 0, 0 }, { 1, 0, 0 }, { 1, 1, 1 }, { 0, 1, 0 } } };
  const FaceMeasures<double> face =
    measuresOfFace(4, [&](std::size_t i) -> const Vector& { return corners[i]; });
  EXPECT_LT(norm(minus(face.area, { -0.5, -0.5, 1 })), 1e-15);
  EXPECT_GT(face.warp, 0);
  EXPECT_LT(face.star, 1);
}

TEST(Cone, OfFacesOfABoxIsItsVolumeWhereverItIs)
{
  const std::array<std::array<unsigned, 4>, 6> faces{ { { 0, 4, 6, 2 }, { 1, 3, 7, 5 },
    { 0, 1, 5, 4 }, { 2, 6, 7, 3 }, { 0, 2, 3, 1 }, { 4, 5, 7, 6 } } };
  for (const double shift : { 0.0, 7.0, -3.0 })
  {
    double volume = 0;
    double pyramids = 0;
    for (const auto& face : faces)
    {
      const auto corner = [&](std::size_t i) {
        return Vector{ shift + (face[i] & 1U), shift + 2 * (face[i] >> 1U & 1U),
          shift + 3 * (face[i] >> 2U) };
      };
      volume += measureCone(4, corner).volume;
      pyramids += pyramidVolume(measureFace(4, corner), { 100, 200, 300 });
    }
    EXPECT_NEAR(volume, 6, 1e-12);
    EXPECT_NEAR(pyramids, 6, 1e-9);
  }
}

TEST(CellMeasures, OfABox)
{
  EXPECT_EQ(sumsOfBox<AreaSums>(1, 1, 1).aspectRatio(1), 1);
  EXPECT_NEAR(sumsOfBox<AreaSums>(1, 2, 4).aspectRatio(8), 4, 1e-12); // 16 across x by 4 across z
  EXPECT_NEAR(sumsOfBox<AreaSums>(1, 2, 4).aspectRatio(1e-3), 28 / 6.0 / 0.01, 1e-9);
  EXPECT_EQ(sumsOfBox<AreaSums>(1, 2, 4).openness(), 0);
  EXPECT_NEAR(sumsOfBox<DeterminantOfCell<double>>(1, 1, 1).value(), 1, 1e-12);
  EXPECT_NEAR(sumsOfBox<AreaSpread>(2, 2, 2).third(), 1, 1e-12);
}

TEST(CellMeasures, OfABoxWithoutItsTop)
{
  const std::array<Vector, 6> areas = areasOfBox(1, 2, 3);
  AreaSums sums;
  DeterminantOfCell<double> across; // of its four sides alone
  AreaSpread spread;
  for (std::size_t f = 0; f < 5; ++f)
  {
    sums.add(areas[f]);
  }
  for (std::size_t f = 0; f < 4; ++f)
  {
    across.add(areas[f]);
    spread.add(areas[f]);
  }
  EXPECT_EQ(sums.openness(), 1);
  EXPECT_EQ(across.value(), 0);
  EXPECT_EQ(spread.third(), 0);
}
