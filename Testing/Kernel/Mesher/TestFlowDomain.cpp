// Domain Outside: the box without the bodies, exactly, with its sides as boundaries.
#include "Base/Error.h"
#include "Mesher/Messages.h"
#include "Support/MeshChecker.h"

#include <gtest/gtest.h>

using namespace cartesian;

namespace
{

constexpr int FirstSide = 10; // of the box: low x, high x, low y, ...
constexpr double Large = 3;   // sides of the box

TestOptions around(double cellSize, const Bounds& box, int levels = 0)
{
  TestOptions options = asTheyAre(0, depth(levels));
  options.grid = cellsOf(cellSize);
  options.domain.domain = Domain::Outside;
  options.domain.boxFrom = BoxSource::Bounds;
  options.domain.bounds = box;
  for (int side = 0; side < 6; ++side)
  {
    options.domain.sides[static_cast<std::size_t>(side)] = FirstSide + side;
  }
  return options;
}

// From -1 to 2 in all directions, but from `ground` along z.
Bounds boxFrom(double ground)
{
  return { { -1, -1, ground }, { -1 + Large, -1 + Large, ground + Large } };
}

// Each side of the box, and the body, is within two steps of the lattice.
double volumeSlack(const MeshArrays& mesh)
{
  return 2 * mesh.step * 7 * Large * Large;
}

MeshArrays meshAround(const Soup& soup, const TestOptions& options)
{
  Execution execution(1);
  const std::unique_ptr<Assembly> assembly = mesh(soup.view(), options, execution);
  return arraysOf(*assembly->mesh, assembly->boxes, execution);
}

// Without boundaries of no area.
void expectAreas(const MeshArrays& mesh, const std::map<int, double>& expected)
{
  std::map<int, double> areas = areasByBoundary(mesh);
  for (const auto& [boundary, area] : expected)
  {
    EXPECT_NEAR(areas[boundary], area, 1e-8 * Large * Large) << "boundary " << boundary;
    areas.erase(boundary);
  }
  for (const auto& [boundary, area] : areas)
  {
    EXPECT_NEAR(area, 0, 1e-8 * Large * Large) << "boundary " << boundary;
  }
}

std::map<int, double> areasOfSides(double ground)
{
  std::map<int, double> areas;
  for (int side = 0; side < 6; ++side)
  {
    areas[FirstSide + side] = Large * Large;
  }
  areas[FirstSide + 4] = ground;
  return areas;
}

}

TEST(FlowDomain, ABodyInABox)
{
  const Soup ball = sphere(6, 0.4);
  for (const double size : { 0.7, 0.31 })
  {
    for (const int levels : { 0, 2 })
    {
      const MeshArrays mesh = meshAround(ball, around(size, boxFrom(-1), levels));
      EXPECT_TRUE(isValid(mesh));
      EXPECT_NEAR(volumeOf(mesh), Large * Large * Large - ball.volume(), volumeSlack(mesh));
      std::map<int, double> areas = areasOfSides(Large * Large);
      for (std::size_t t = 0; t < ball.triangles.size(); ++t)
      {
        areas[ball.boundaryOf(t)] += ball.area(t);
      }
      expectAreas(mesh, areas);
    }
  }
}

// The bottom, which is boundary 4, is no boundary of the mesh, and nothing is left under it.
TEST(FlowDomain, ABodyStandsOnTheGround)
{
  for (const double size : { 1.0, 0.31 })
  {
    for (const int levels : { 0, 1 })
    {
      const MeshArrays mesh = meshAround(cube(), around(size, boxFrom(0), levels));
      EXPECT_TRUE(isValid(mesh));
      EXPECT_NEAR(volumeOf(mesh), Large * Large * Large - 1, volumeSlack(mesh));
      std::map<int, double> areas = areasOfSides(Large * Large - 1);
      for (const int side : { 0, 1, 2, 3, 5 })
      {
        areas[side] = 1;
      }
      expectAreas(mesh, areas);
    }
  }
}

TEST(FlowDomain, ABodyIsCutOffByTheGround)
{
  const Soup body = octahedron(0.5);
  for (const double size : { 0.7, 0.31 })
  {
    const MeshArrays mesh = meshAround(body, around(size, boxFrom(0)));
    EXPECT_TRUE(isValid(mesh));
    EXPECT_NEAR(volumeOf(mesh), Large * Large * Large - body.volume() / 2, volumeSlack(mesh));
    std::map<int, double> areas = areasOfSides(Large * Large - 0.5);
    areas[0] = body.area() / 2;
    expectAreas(mesh, areas);
  }
}

TEST(FlowDomain, WithCellsForSolversTheSidesKeepTheirNames)
{
  TestOptions options = around(0.31, boxFrom(0), 1);
  TestOptions defaults;
  options.patches = defaults.patches;
  options.collapse = defaults.collapse;
  options.smallCells = defaults.smallCells;
  options.shaping = defaults.shaping;
  const MeshArrays mesh = meshAround(octahedron(0.5), options);
  EXPECT_TRUE(isValid(mesh, true));
  std::map<int, double> areas = areasByBoundary(mesh);
  for (const auto& [side, area] : areasOfSides(Large * Large - 0.5))
  {
    EXPECT_NEAR(areas[side], area, 0.02 * area) << "boundary " << side;
  }
  EXPECT_EQ(areas.count(NoBoundary), 0U);
}

TEST(FlowDomain, TheBoxComesFromTheSurface)
{
  const Bounds surface{ { 0, 0, 0 }, { 2, 1, 1 } };
  DomainSpec spec;
  spec.flow = FlowDirection::MinusX;
  spec.ground = DomainSide::ZMin;
  spec.half = Half::AcrossY;
  const Bounds box = boxAround(spec, surface);
  EXPECT_EQ(box.low, (std::array<double, 3>{ -10, 0.5, 0 }));
  EXPECT_EQ(box.high, (std::array<double, 3>{ 8, 7, 7 }));
}

TEST(FlowDomain, BadBoxesAreRefused)
{
  const auto expectRefusal = [](const Bounds& box, const std::string& words) {
    try
    {
      meshAround(cube(), around(0.31, box));
      ADD_FAILURE() << "nothing was thrown";
    }
    catch (const Error& error)
    {
      EXPECT_EQ(error.fault, Fault::BadParameter);
      EXPECT_NE(std::string(error.what()).find(words), std::string::npos) << error.what();
    }
  };
  expectRefusal(boxFrom(5), "5 to 8 along z and misses");
  expectRefusal({ { -1, 2, -1 }, { 2, -1, 2 } }, "2 to -1 along y: give the lower bound first");
  expectRefusal({ { -1, -1, -1 }, { 2, 2, 1e9 } }, "choose a smaller box");
}

TEST(FlowDomain, SeveralRegionsAreRefused)
{
  const Soup two = Soup(cube()).addRegion(cube().moved({ 1, 0, 0 }));
  EXPECT_THROW(meshAround(two, around(0.31, boxFrom(-0.5))), Error);
}

TEST(FlowDomain, SidesAreNamedByAxesOrByTheFlow)
{
  using Names = std::array<std::string, 6>;
  DomainSpec spec;
  spec.flow = FlowDirection::MinusY;
  spec.ground = DomainSide::ZMin;
  spec.sideNames = SideNames::Axes;
  EXPECT_EQ(namesOfSides(spec), (Names{ "xMin", "xMax", "yMin", "yMax", "zMin", "zMax" }));
  spec.sideNames = SideNames::Flow;
  EXPECT_EQ(namesOfSides(spec), (Names{ "sides", "sides", "outlet", "inlet", "ground", "sides" }));
  spec.half = Half::AcrossX;
  EXPECT_EQ(
    namesOfSides(spec), (Names{ "symmetry", "sides", "outlet", "inlet", "ground", "sides" }));
}

TEST(FlowDomain, TooFewBoxesAlongABodyAreTold)
{
  DomainSpec domain;
  domain.domain = Domain::Outside;
  domain.boxesAlong = 1000;
  domain.boxFrom = BoxSource::Bounds;
  domain.bounds = { { -4096, -4096, -4096 }, { 4096, 4096, 4096 } };
  const Bounds body{ { 0, 0, 0 }, { 4, 2, 1 } };
  EXPECT_EQ(describeShortfall(domain, flowRefinement(domain, cellsOf(64), body)),
    "Boxes Along Body is 1000, but only 256 fit along the surface: boxes can be halved at most 12 "
    "times. Choose a Cell Size of 16.384 or less, or closer Meshlines.");
  EXPECT_EQ(describeShortfall(domain, flowRefinement(domain, cellsOf(16), body)), "");
}

// At the wall boxes may be far smaller, but not in zones, which they would fill.
TEST(FlowDomain, ZonesAreNoFinerThanTheFlowNeeds)
{
  DomainSpec domain;
  domain.domain = Domain::Outside;
  domain.boxFrom = BoxSource::Bounds;
  domain.bounds = { { -20, -10, 0 }, { 40, 10, 14 } };
  const Bounds body{ { 0, -1, 0 }, { 4.5, 1, 1.5 } };
  const std::vector<std::array<int, 4>> expected = { { 18, 3, 2, 1 }, { 60, 5, 4, 3 },
    { 144, 6, 5, 4 }, { 288, 7, 5, 4 }, { 1000, 9, 5, 4 } };
  for (const auto& [along, depth, around, wake] : expected)
  {
    domain.boxesAlong = along;
    const FlowRefinement flow = flowRefinement(domain, cellsOf(2), body);
    EXPECT_EQ(flow.depth, depth) << along;
    ASSERT_EQ(flow.zones.size(), 2U);
    EXPECT_EQ(flow.zones[0].depth, around) << along;
    EXPECT_EQ(flow.zones[1].depth, wake) << along;
  }
}
