// Layers that are far thinner than the boxes beside them, as models that resolve the wall want them.
#include "Layers/BoundaryLayers.h"
#include "Layers/FaceDivision.h"

#include "Base/Error.h"
#include "Polyhedra/CellGeometry.h"
#include "Support/Pipeline.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <map>

namespace cartesian
{

namespace
{

WallLayerSpec automaticLayers(double first)
{
  WallLayerSpec spec;
  spec.count = WallLayerSpec::Automatic;
  spec.firstThickness = first;
  return spec;
}

// A polygon over a regular one of radius 1, with these heights at its corners.
std::vector<Vector> polygon(const std::vector<double>& heights)
{
  std::vector<Vector> corners;
  for (std::size_t i = 0; i < heights.size(); ++i)
  {
    const double angle = 2 * Pi * double(i) / double(heights.size());
    corners.push_back({ std::cos(angle), std::sin(angle), heights[i] });
  }
  return corners;
}

constexpr Vector Below{ 0, 0, -1 };

Vector areaOf(const std::vector<Vector>& corners, const FaceDivision::Part& part)
{
  return measureFace(part.size(), [&](std::size_t i) { return corners[part[i]]; }).area;
}

// Whether the parts have the polygon's edges, and each of their other edges once each way.
bool cover(const std::vector<FaceDivision::Part>& parts, std::size_t corners)
{
  std::map<std::array<std::uint32_t, 2>, int> edges;
  for (const FaceDivision::Part& part : parts)
  {
    for (std::size_t i = 0; i < part.size(); ++i)
    {
      ++edges[{ part[i], part[(i + 1) % part.size()] }];
      --edges[{ part[(i + 1) % part.size()], part[i] }];
    }
  }
  std::size_t around = 0;
  for (const auto& [edge, uses] : edges)
  {
    const bool isOfPolygon = edge[1] == (edge[0] + 1) % corners;
    around += isOfPolygon && uses == 1 ? 1 : 0;
    if (!isOfPolygon && edge[0] != (edge[1] + 1) % corners && uses != 0)
    {
      return false;
    }
  }
  return around == corners;
}

// The share of whole stacks on walls, by area as the boundary's faces have it.
double wholeShare(const Soup& soup, double firstByBox)
{
  Execution execution(1);
  TestOptions options;
  options.grid = cellsAlongLongest(soup, 12);
  options.layers.count = 12;
  options.layers.firstThickness = firstByBox / 12;
  options.memoryLimit = PlentyOfMemory;
  const PreparedSurface prepared = prepareSurface(soup.view(), options, execution);
  const auto decomposition = decompose(prepared, options, execution);
  const auto assembly =
    meshPart(prepared, *decomposition, decomposition->allLayers(), options, execution);
  const LayeredBoundary& boundary = assembly->layers->boundary;
  std::vector<double> xyz(3 * std::size_t(assembly->mesh->pointCount()));
  assembly->mesh->writePoints(xyz.data(), execution);
  for (const MovedPoint& moved : assembly->layers->stacks.moved)
  {
    std::copy(moved.to.begin(), moved.to.end(), &xyz[3 * std::size_t(moved.point)]);
  }
  const std::vector<double>& more = assembly->layers->stacks.points;
  xyz.insert(xyz.end(), more.begin(), more.end());
  double whole = 0;
  double all = 0;
  for (std::size_t f = 0; f < boundary.faces.size(); ++f)
  {
    const auto first = std::size_t(boundary.mesh.start[f]);
    const double area =
      norm(measureFace(std::size_t(boundary.mesh.start[f + 1]) - first, [&](std::size_t i) {
        const Id p = boundary.mesh.meshPoint[std::size_t(boundary.mesh.corners[first + i])];
        return Vector{ xyz[3 * std::size_t(p)], xyz[3 * std::size_t(p) + 1],
          xyz[3 * std::size_t(p) + 2] };
      }).area);
    all += boundary.stacks[f].asked > 0 ? area : 0;
    whole += boundary.stacks[f].isWhole ? area : 0;
  }
  return whole / all;
}

}

// From 1e-3 and 1e-4 of a box to a tenth of it, by a fifth each.
TEST(ThinLayers, AnAutomaticNumberLeadsToTheLastLayer)
{
  constexpr double Box = 0.02;
  EXPECT_EQ(layersTo(automaticLayers(1e-3 * Box), Box), 26);
  EXPECT_EQ(layersTo(automaticLayers(1e-4 * Box), Box), 38);
  EXPECT_EQ(layersTo(automaticLayers(Box), Box), 1);
  for (const double first : { 1e-2 * Box, 1e-3 * Box, 1e-4 * Box })
  {
    const WallLayerSpec spec = withNumber(automaticLayers(first), Box);
    const double total = totalThickness(spec, Box);
    const std::vector<double> heights = heightsOfLayers(spec);
    const double last = total * (1 - heights[heights.size() - 2]);
    EXPECT_LE(last, 0.1 * Box * (1 + 1e-9));
    EXPECT_GT(last * spec.ratio, 0.1 * Box);
    EXPECT_NEAR(total * heights[1], first, 1e-12 * Box);
  }
}

TEST(ThinLayers, AnAutomaticNumberNeedsAFirstThickness)
{
  EXPECT_THROW(requireValid(automaticLayers(0)), Error);
  WallLayerSpec growing = automaticLayers(0.001);
  EXPECT_NO_THROW(requireValid(growing));
  growing.ratio = 1;
  EXPECT_THROW(requireValid(growing), Error);
}

// The centre of the first cell has the y+ that was asked for, by the plate's friction.
TEST(ThinLayers, TheFirstThicknessFollowsFromYPlus)
{
  WallFlow flow;
  flow.targetYPlus = 1;
  const double length = 1;
  const double first = firstThicknessFor(flow, length);
  EXPECT_NEAR(first, 6.734e-5, 1e-8); // by hand, of air at 10 m/s along 1 m
  flow.targetYPlus = 50;
  EXPECT_NEAR(firstThicknessFor(flow, length), 50 * first, 1e-12);
  flow.length = 4;
  EXPECT_NEAR(firstThicknessFor(flow, length), 50 * first * std::pow(4, 0.1), 1e-12);
}

// The same layers, as many as fit; others become thinner alike.
TEST(ThinLayers, FlatStacksHaveFewerLayers)
{
  WallLayerSpec spec;
  spec.count = 5;
  const LayerHeights heights(spec);
  EXPECT_EQ(heights.layersIn(0, true), 0U);
  EXPECT_EQ(heights.layersIn(1, true), 5U);
  EXPECT_EQ(heights.layersIn(0.1, false), 5U);
  for (std::size_t fit = 1; fit <= 5; ++fit)
  {
    const double part = heights.at(1, fit, true);
    EXPECT_EQ(heights.layersIn(part, true), fit);
    EXPECT_EQ(heights.fitting(part + 1e-3, true), fit < 5 ? part : 1);
    for (std::size_t k = 0; k <= 5; ++k)
    {
      EXPECT_EQ(heights.at(part, k, true), heights.at(1, std::min(k, fit), true));
    }
  }
  EXPECT_NEAR(heights.at(0.9, 1, false), heights.at(1, 1, false), 1e-12);
}

TEST(FaceDivision, KeepsFlatPolygons)
{
  FaceDivision division;
  for (std::size_t size = 4; size < 9; ++size)
  {
    const std::vector<Vector> corners = polygon(std::vector<double>(size, 0.25));
    EXPECT_EQ(division.divide(corners, Below, { 1e-9, 1e-9 }).size(), 1U);
  }
}

TEST(FaceDivision, DividesASaddleIntoTwoTriangles)
{
  FaceDivision division;
  const std::vector<Vector> corners = polygon({ 0.01, -0.01, 0.01, -0.01 });
  EXPECT_EQ(division.divide(corners, Below, { 1, 0.011 }).size(), 1U);
  const auto& parts = division.divide(corners, Below, { 1, 0.009 });
  ASSERT_EQ(parts.size(), 2U);
  EXPECT_EQ(parts[0].size(), 3U);
  EXPECT_TRUE(cover(parts, 4));
}

// Fewer parts than triangles, each within a plane.
TEST(FaceDivision, JoinsWhatIsFlatTogether)
{
  FaceDivision division;
  const std::vector<Vector> corners = polygon({ 0, -0.05, -0.05, 0, -0.05, -0.05 });
  const auto& parts = division.divide(corners, Below, { 1e-9, 1e-9 });
  EXPECT_LT(parts.size(), 4U);
  EXPECT_TRUE(cover(parts, 6));
  for (const FaceDivision::Part& part : parts)
  {
    const Vector normal = unit(areaOf(corners, part));
    for (const std::uint32_t i : part)
    {
      EXPECT_NEAR(dot(normal, minus(corners[i], corners[part[0]])), 0, 1e-9);
    }
  }
}

// Other faces have them as edges.
TEST(FaceDivision, LeavesOutBarredDiagonals)
{
  FaceDivision division;
  const std::vector<Vector> saddle = polygon({ 0.01, -0.01, 0.01, -0.01 });
  for (const FaceDivision::Diagonal& barred : { FaceDivision::Diagonal{ 0, 2 }, { 1, 3 } })
  {
    const auto& parts = division.divide(saddle, Below, { 1e-3, 1e-3 }, { barred });
    ASSERT_EQ(parts.size(), 2U);
    for (const FaceDivision::Part& part : parts)
    {
      EXPECT_TRUE(std::find(part.begin(), part.end(), barred[0]) == part.end() ||
        std::find(part.begin(), part.end(), barred[1]) == part.end());
    }
  }
  EXPECT_EQ(division.divide(saddle, Below, { 1e-3, 1e-3 }, { { 0, 2 }, { 1, 3 } }).size(), 1U);
}

// The parts' areas add up to the polygon's, and each faces as it does.
TEST(FaceDivision, CoversAnyPolygon)
{
  FaceDivision division;
  for (std::size_t size = 4; size < 11; ++size)
  {
    std::vector<double> heights;
    for (std::size_t i = 0; i < size; ++i)
    {
      heights.push_back(0.02 * std::sin(double(3 * i * i + size)));
    }
    const std::vector<Vector> corners = polygon(heights);
    const auto& parts = division.divide(corners, Below, { 1e-3, 1e-3 });
    EXPECT_GT(parts.size(), 1U);
    EXPECT_TRUE(cover(parts, size));
    FaceDivision::Part whole;
    for (std::size_t i = 0; i < size; ++i)
    {
      whole.push_back(std::uint32_t(i));
    }
    Vector sum{};
    for (const FaceDivision::Part& part : parts)
    {
      sum = plus(sum, areaOf(corners, part));
      EXPECT_GT(areaOf(corners, part)[2], 0);
    }
    EXPECT_NEAR(norm(minus(sum, areaOf(corners, whole))), 0, 1e-12);
  }
}

// Divided, its parts would be seen from the centre at more than solvers bear.
TEST(FaceDivision, KeepsWhatACellHardlySees)
{
  FaceDivision division;
  const std::vector<Vector> corners = polygon({ 0.01, -0.01, 0.01, -0.01 });
  EXPECT_EQ(division.divide(corners, { 0, 0, -0.05 }, { 1e-3, 1e-3 }).size(), 1U);
}

// Boundary layers are solved at aspect ratios of ten thousand: stacks on flat walls do not depend on their height.
TEST(ThinLayers, StacksOnFlatWallsStandAtAnyAspectRatio)
{
  EXPECT_NEAR(wholeShare(cube(), 1e-2), 1, 1e-12);
  EXPECT_NEAR(wholeShare(cube(), 1e-3), 1, 1e-12);
  EXPECT_NEAR(wholeShare(cube(), 1e-4), 1, 1e-12);
}

TEST(ThinLayers, StacksOnTurnedWallsStandAtAnyAspectRatio)
{
  const double thick = wholeShare(cube().turned(), 1e-2);
  EXPECT_GE(wholeShare(cube().turned(), 1e-3), thick);
  EXPECT_GE(wholeShare(cube().turned(), 1e-4), thick);
}

// What is above the regular layers is at least as high where it is lowest as it differs, and leans little; or it begins at the
// wall.
TEST(ThinLayers, WhatDiffersIsOneCell)
{
  constexpr double Slenderness = 2;
  WallLayerSpec spec;
  spec.count = 20;
  const LayerHeights heights(spec);
  const auto end = [&](std::size_t k) { return heights.at(1, k, true); };
  for (std::size_t least = 0; least <= 20; ++least)
  {
    EXPECT_EQ(heights.layersBelow(least, least, 1), least);
    for (std::size_t most = least + 1; most <= 20; ++most)
    {
      const std::size_t below = heights.layersBelow(least, most, Slenderness);
      ASSERT_LE(below, least);
      const double differs = end(most) - end(least);
      const double height = (end(most) + end(least)) / 2 - end(below);
      EXPECT_TRUE(below == 0 ||
        (end(least) - end(below) >= differs &&
          Slenderness * differs / (12 * height) <= height / 2));
    }
  }
}

// Where a wall bends within a box there are smaller ones, as many more as are told; layers are chosen by boxes half as
// large as most then. Not where boundaries without layers bend.
TEST(ThinLayers, WallsThatBendGetSmallerBoxes)
{
  Execution execution(1);
  const Soup soup = torus(24, 0.4, 0.15).turned();
  TestOptions options;
  options.grid = cellsOf(0.12);
  options.memoryLimit = PlentyOfMemory;
  options.layers = automaticLayers(1e-3 * 0.12);
  const auto refined = mesh(soup.view(), options, execution);
  options.layers.refine = false;
  const auto plain = mesh(soup.view(), options, execution);
  const auto boxes = [](const Assembly& a) { return a.boxes.packed.size(); };
  EXPECT_GT(2 * boxes(*refined), 3 * boxes(*plain));
  EXPECT_EQ(refined->layers->boxesAdded, boxes(*refined) - boxes(*plain));
  EXPECT_EQ(plain->layers->boxesAdded, 0U);
  EXPECT_EQ(plain->layers->spec.count, layersTo(options.layers, 0.12));
}

// Where walls come closer and closer there are fewer layers, and the first is as high as elsewhere.
TEST(ThinLayers, StacksBetweenWallsKeepTheirFirstLayer)
{
  Execution execution(1);
  const Soup soup =
    tetrahedron({ Vector{ 0, 0, 0 }, { 2, 0, 0 }, { 0, 2, 0 }, { 0, 0, 0.4 } }).turned();
  TestOptions options;
  options.grid = cellsAlongLongest(soup, 40);
  options.layers.count = 20;
  options.layers.firstThickness = 1e-3 * 2 / 40;
  options.memoryLimit = PlentyOfMemory;
  const auto assembly = mesh(soup.view(), options, execution);
  std::size_t fewer = 0;
  for (const StackMeasure& stack : assembly->layers->boundary.stacks)
  {
    fewer += stack.layers > 1 && stack.layers < 20 ? 1 : 0;
    EXPECT_TRUE(stack.layers < 2 || stack.keepsFirst);
  }
  EXPECT_GT(fewer, 0U);
}

}
