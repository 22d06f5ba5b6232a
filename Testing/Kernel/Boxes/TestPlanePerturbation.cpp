// SPDX-License-Identifier: BSD-3-Clause
#include "Boxes/PlanePerturbation.h"

#include "Support/Pipeline.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

using namespace cartesian;

namespace
{

// The planes after they stepped aside from a box between the levels 11 and 101 along x and y, and those
// given along z.
Meshlines planesBeside(double low, double high, const std::vector<Level>& along, int depth = 0)
{
  const std::vector<Level> across{ 0, along.back() };
  const Meshlines given{ { across, across, along } };
  const PreparedSurface prepared = prepareOnLevels(box({ 11, 11, low }, { 101, 101, high }), given);
  Meshlines planes = given;
  Execution execution;
  stepAside(prepared.surface, depth, planes, execution);
  return planes;
}

Level meshlineBeside(double low, double high, Level plane)
{
  return planesBeside(low, high, { 0, plane, 200 })[2][1];
}

// Of two boxes' common plane, which halves the space between two meshlines.
Level halfBeside(double low, double high)
{
  const Meshlines planes = planesBeside(low, high, { 0, 12800 });
  return planeAt(planes, 2, FinePerBox / 2);
}

// A house along y, upside down if its base is above its ridge.
Soup gable(double ridge, double eaves, double base)
{
  Soup soup;
  soup.points = { { 11, 11, base }, { 101, 11, base }, { 101, 101, base }, { 11, 101, base },
    { 11, 11, eaves }, { 101, 11, eaves }, { 101, 101, eaves }, { 11, 101, eaves },
    { 57, 11, ridge }, { 57, 101, ridge } };
  soup.triangles = { { 0, 2, 1 }, { 0, 3, 2 }, { 1, 2, 6 }, { 1, 6, 5 }, { 3, 0, 4 }, { 3, 4, 7 },
    { 0, 1, 5 }, { 0, 5, 8 }, { 0, 8, 4 }, { 2, 3, 7 }, { 2, 7, 9 }, { 2, 9, 6 }, { 5, 6, 9 },
    { 5, 9, 8 }, { 7, 4, 8 }, { 7, 8, 9 } };
  return (base < ridge ? soup : soup.flipped());
}

// Of two boxes' common plane, beside these bodies, which are gables along z: the same along each axis.
Level halfBesideGables(const std::vector<std::array<double, 3>>& gables)
{
  std::array<Level, 3> half{};
  for (int axis = 0; axis < 3; ++axis)
  {
    Soup soup;
    for (const auto& [ridge, eaves, base] : gables)
    {
      soup.add(gable(ridge, eaves, base)
                 .permuted({ axis == 0 ? 2 : 0, axis == 1 ? 2 : 1,
                   axis == 0     ? 0
                     : axis == 1 ? 1
                                 : 2 }));
    }
    Meshlines planes;
    planes.lines.fill({ 0, 200 });
    planes[static_cast<std::size_t>(axis)] = { 0, 12800 };
    const PreparedSurface prepared = prepareOnLevels(soup, planes);
    Execution execution;
    stepAside(prepared.surface, 0, planes, execution);
    half[static_cast<std::size_t>(axis)] =
      planeAt(planes, static_cast<std::size_t>(axis), FinePerBox / 2);
  }
  EXPECT_EQ(half[0], half[1]);
  EXPECT_EQ(half[0], half[2]);
  return half[2];
}

// Two regions along an axis: a cylinder of this radius, which touches planes, in a tube.
Soup cylinderInTube(double radius, int axis, double size, const Vector& by)
{
  constexpr int Sides = 200;
  constexpr double Length = 4;
  constexpr double Outer = 10;
  const auto corner = [](double r, int i, double z) {
    const double angle = 2 * std::acos(-1.0) * i / Sides;
    return Vector{ r * std::cos(angle), r * std::sin(angle), z };
  };
  Soup cylinder;
  Soup tube;
  const auto add = [](Soup& to, const std::array<Vector, 4>& quad) {
    const auto first = static_cast<std::uint32_t>(to.points.size());
    to.points.insert(to.points.end(), quad.begin(), quad.end());
    to.triangles.push_back({ first, first + 1, first + 2 });
    to.triangles.push_back({ first, first + 2, first + 3 });
  };
  for (int i = 0; i < Sides; ++i)
  {
    const int j = (i + 1) % Sides;
    const auto at = [&](double r, int side, double z) { return corner(r, side, z); };
    const auto wall = [&](double r) {
      return std::array<Vector, 4>{ at(r, i, 0), at(r, j, 0), at(r, j, Length), at(r, i, Length) };
    };
    const auto end = [&](double r, double s, double z) {
      return std::array<Vector, 4>{ at(r, i, z), at(s, i, z), at(s, j, z), at(r, j, z) };
    };
    add(cylinder, wall(radius));
    add(tube, wall(Outer));
    std::array<Vector, 4> inner = wall(radius);
    std::reverse(inner.begin(), inner.end());
    add(tube, inner);
    add(tube, end(radius, Outer, Length));
    add(tube, end(Outer, radius, 0));
    const auto first = static_cast<std::uint32_t>(cylinder.points.size());
    cylinder.points.insert(cylinder.points.end(),
      { { 0, 0, 0 }, at(radius, j, 0), at(radius, i, 0), { 0, 0, Length }, at(radius, i, Length),
        at(radius, j, Length) });
    cylinder.triangles.push_back({ first, first + 1, first + 2 });
    cylinder.triangles.push_back({ first + 3, first + 4, first + 5 });
  }
  const auto place = [&](const Soup& soup) {
    return soup.permuted({ (3 - axis) % 3, (4 - axis) % 3, (5 - axis) % 3 }).scaled(size).moved(by);
  };
  return Soup().addRegion(place(cylinder)).addRegion(place(tube));
}

}

TEST(PlanePerturbation, APlaneUnderARoofStepsAboveIt)
{
  EXPECT_EQ(meshlineBeside(11, 51, 50), 52U); // the domain ends at 51
}

TEST(PlanePerturbation, APlaneOverAFloorStepsBelowIt)
{
  EXPECT_EQ(meshlineBeside(51, 101, 52), 50U); // the domain begins at 51
}

TEST(PlanePerturbation, PlanesThatLeaveNoFlangeStay)
{
  EXPECT_EQ(meshlineBeside(11, 51, 52), 52U);
  EXPECT_EQ(meshlineBeside(51, 101, 50), 50U);
  EXPECT_EQ(meshlineBeside(11, 51, 30), 30U);
}

TEST(PlanePerturbation, APlaneThatDividesABoxStepsToo)
{
  EXPECT_EQ(halfBeside(11, 6401), 6402U);
  EXPECT_EQ(halfBeside(6399, 10001), 6398U);
  EXPECT_EQ(halfBeside(11, 6399), 6400U);
  EXPECT_EQ(halfBeside(11, 6501), 6400U); // far from the wall
}

// The wall runs along the first of the planes that divide the space between two meshlines into 512.
TEST(PlanePerturbation, PlanesOfDeepBoxesStepToo)
{
  constexpr std::int64_t Step = FinePerBox / 512;
  for (const int depth : { 0, 6, 8, 9, 12 })
  {
    const Meshlines planes = planesBeside(11, 1001, { 0, 512000 }, depth);
    EXPECT_EQ(planes.planeLevel, std::max(6, depth));
    EXPECT_EQ(planeAt(planes, 2, Step), depth < 9 ? 1000U : 1002U) << depth;
    EXPECT_EQ(planeAt(planes, 2, 2 * Step), 2000U);
  }
}

// The clearance of points is a level here; planes keep two more, for rounding.
TEST(PlanePerturbation, PlanesKeepOffRidgesAndPits)
{
  EXPECT_EQ(halfBesideGables({ { 6401, 6391, 11 } }), 6404U); // the domain ends at 6401
  EXPECT_EQ(halfBesideGables({ { 6399, 6391, 11 } }), 6402U);
  EXPECT_EQ(halfBesideGables({ { 6399, 6409, 10001 } }), 6396U); // it begins at 6399
  EXPECT_EQ(halfBesideGables({ { 6401, 6411, 10001 } }), 6398U);
}

TEST(PlanePerturbation, PlanesThatAreTangentToNothingStay)
{
  EXPECT_EQ(halfBesideGables({ { 6405, 6391, 11 } }), 6400U); // the cap is thick enough
  EXPECT_EQ(halfBesideGables({ { 6395, 6391, 11 } }), 6400U); // the plane is far enough above it
  EXPECT_EQ(halfBesideGables({ { 6401, 6301, 11 } }), 6400U); // a steep roof
  EXPECT_EQ(halfBesideGables({ { 6421, 6401, 11 } }), 6400U); // the foot of a roof, at a wall
}

// Ridge on ridge: one of them is cut, but not thinner than the distance that points keep.
TEST(PlanePerturbation, PlanesKeepOffRidgesThatTouch)
{
  for (const double level : { 6397, 6399, 6401, 6403 })
  {
    const Level half =
      halfBesideGables({ { level, level - 10, 11 }, { level, level + 10, 10001 } });
    EXPECT_TRUE(half == level - 3 || half == level + 3) << half << " beside " << level;
  }
}

// PlaneClearance.h; a cell that is as thin has a smaller share of its box.
constexpr double ClearanceInBoxes = 1.0 / (1 << 19);

// The cylinder is tangent to planes of the grid along four lines: at round numbers, in this place too, it was cut there
// by 1e-6 of a box, and as little stayed on the other side.
TEST(PlanePerturbation, CylindersThatTouchPlanesLeaveNoSlivers)
{
  for (const double off : { 0.0, 1e-7, -1e-7 })
  {
    for (int axis = 0; axis < 3; ++axis)
    {
      for (const double size : { 1.0, 1e-3 })
      {
        SCOPED_TRACE(testing::Message() << off << " off, axis " << axis << ", size " << size);
        const Soup soup = cylinderInTube(8 + off, axis, size, { 3 * size, 0, -size });
        const Meshed meshed = meshOf(soup, cellsOf(size), TestOptions());
        const std::vector<double>& share = meshed.mesh.volumeFraction;
        EXPECT_GT(*std::min_element(share.begin(), share.end()), ClearanceInBoxes);
        const Meshed exact = meshOf(soup, cellsOf(size));
        EXPECT_NEAR(exact.statistics.at("MeshVolume") / soup.volume(), 1, 1e-9);
      }
    }
  }
}

// 0.6 in single precision is 2.4e-8 more: a flange of 25 levels here.
TEST(PlanePerturbation, WallsInSinglePrecisionRunAlongPlanesInDouble)
{
  const double top = float(0.6);
  Soup soup = box({ 0, 0, 0 }, { 1, 1, 1 });
  soup.add(box({ 2, 0, 0 }, { 3, 1, top }));
  for (const double size :
    { 0.05, 0.1, 0.2, 0.4, 0.8 }) // 0.4: the wall runs along a half; 0.8: a quarter
  {
    const PreparedSurface prepared = prepare(soup, cellsOf(size));
    const auto fine = std::lround(0.6 / size * double(FinePerBox));
    EXPECT_EQ(planeAt(prepared.planes, 2, fine), prepared.surface.lattice.vertex(2, top) + 1)
      << size;
  }
}
