// The wall as a whole, from raw cells to the mesh.
#include "Editing/EditLoop.h"
#include "Editing/EditMeasures.h"
#include "Editing/ShortEdges.h"
#include "Editing/TrueVolume.h"
#include "Editing/WallCentring.h"
#include "Editing/WallOpening.h"
#include "Editing/WallSimplification.h"
#include "Support/MeshChecker.h"
#include "Support/WallCases.h"

#include <gtest/gtest.h>

#include <cmath>
#include <optional>
#include <tuple>

namespace cartesian
{

namespace
{

// Patches keep off the planes of boxes (PlaneClearance.h), by some millionths of a box.
constexpr double OffPlanes = 1e-5;

Meshed meshInPlace(const WallCase& one)
{
  TestOptions options = optionsInPlace(one);
  options.memoryLimit = PlentyOfMemory;
  return meshOf(one.soup, cellsOf(one.size), options);
}

std::vector<WallCase> planeCases()
{
  std::vector<WallCase> all;
  for (int levels = 0; levels <= 2; ++levels)
  {
    const std::string name = std::to_string(levels);
    const double size = 0.13 * (1 << levels);
    all.push_back({ "Cube" + name, cube(), size, levels });
    all.push_back({ "CubeTurned" + name, cube().turned(), size, levels });
    all.push_back({ "BoxTurned" + name, box({ 0, 0, 0 }, { 2, 1, 1.5 }).turned(), size, levels });
  }
  return all;
}

std::vector<WallCase> smoothCases()
{
  std::vector<WallCase> all;
  for (int levels = 0; levels <= 2; ++levels)
  {
    const std::string name = std::to_string(levels);
    const double size = 0.13 * (1 << levels);
    all.push_back({ "Ball" + name, sphere(24, 1), size, levels });
    all.push_back({ "BallTurned" + name, sphere(24, 1).turned(), size, levels });
    all.push_back({ "Torus" + name, torus(48, 1, 0.4).turned(), size, levels });
  }
  return all;
}

// Boxes with rods thinner than a box in them: cells around a rod are rings.
std::vector<WallCase> rodCases()
{
  std::vector<WallCase> all;
  for (const double thickness : { 0.1, 0.3 })
  {
    const Soup rod = box({ 0, 0, 0 }, { 11, thickness, thickness }).flipped();
    const Soup turned = rod.turned(2, 8.0).turned(1, 11.0).moved({ 4.3, 4.1, 6.2 });
    all.push_back(
      { thickness < 0.2 ? "Thin" : "Thick", box({ 0, 0, 0 }, { 20, 10, 10 }).add(turned), 1, 0 });
  }
  return all;
}

class PlaneWallsOf : public ::testing::TestWithParam<WallCase>
{
};

class SmoothWallsOf : public ::testing::TestWithParam<WallCase>
{
};

std::uint32_t bit(Measure measure)
{
  return 1U << measure;
}

// Of what solvers cannot do with.
int failingCells(const MeshArrays& mesh, std::optional<int> region = {})
{
  const std::uint32_t hard = bit(Volume) | bit(Openness) | bit(OpenEdges) | bit(BoundaryAngle) |
    bit(InnerAngle) | bit(StarTriangulation) | bit(Skewness) | bit(NonOrthogonality);
  int count = 0;
  for (const std::uint32_t failures : qualityOf(mesh, region).cellFailures)
  {
    count += (failures & hard) != 0 ? 1 : 0;
  }
  return count;
}

TEST_P(PlaneWallsOf, KeepVolumeAndAreas)
{
  const MeshArrays mesh = meshInPlace(GetParam()).mesh;
  EXPECT_TRUE(isValid(mesh, true));
  EXPECT_EQ(failingCells(mesh), 0);
  const double volume = GetParam().soup.volume();
  EXPECT_NEAR(volumeOf(mesh), volume, OffPlanes * volume);
  const auto areas = areasByBoundary(mesh);
  for (const auto& [boundary, area] : areasByBoundary(GetParam().soup))
  {
    EXPECT_NEAR(areas.at(boundary), area, OffPlanes * area) << boundary;
  }
}

TEST_P(SmoothWallsOf, AreGoodForSolvers)
{
  const MeshArrays mesh = meshInPlace(GetParam()).mesh;
  EXPECT_TRUE(isValid(mesh, true));
  EXPECT_EQ(failingCells(mesh), 0);
}

INSTANTIATE_TEST_SUITE_P(
  WallImprovement, PlaneWallsOf, ::testing::ValuesIn(planeCases()), nameOfCase);
INSTANTIATE_TEST_SUITE_P(Rods, SmoothWallsOf, ::testing::ValuesIn(rodCases()), nameOfCase);
INSTANTIATE_TEST_SUITE_P(
  WallImprovement, SmoothWallsOf, ::testing::ValuesIn(smoothCases()), nameOfCase);

double smallestCell(const MeshArrays& mesh, int region)
{
  double least = HUGE_VAL;
  for (const CellGeometry& cell : qualityOf(mesh, region).cellGeometry)
  {
    least = std::min(least, cell.volume);
  }
  return least;
}

// Walls between regions are walls of both.
TEST(WallImprovement, RegionsKeepVolumesAndAreas)
{
  Soup beside = Soup().addRegion(cube()).addRegion(cube().moved({ 1, 0, 0 })).turned();
  const Soup within =
    Soup().addRegion(box({ 0.25, 0.25, 0.375 }, { 0.75, 0.875, 0.625 })).addRegion(cube());
  const double volumeWithin = 0.5 * 0.625 * 0.25;
  const double areaWithin = 2 * (0.5 * 0.625 + 0.5 * 0.25 + 0.625 * 0.25);
  for (const auto& [soup, size, volume, area] :
    { std::tuple{ beside, 0.13, 1.0, 1.0 }, { within.turned(), 0.09, volumeWithin, areaWithin },
      { within, 1 / 3.7, volumeWithin, areaWithin } })
  {
    const MeshArrays mesh = meshInPlace({ "", soup, size, 0 }).mesh;
    EXPECT_TRUE(isValid(mesh, true));
    EXPECT_NEAR(volumesByRegion(mesh).at(1), volume, OffPlanes * volume);
    EXPECT_NEAR(areasBetweenRegions(mesh).at({ 1, 2 }), area, OffPlanes * area);
    for (const int region : { 1, 2 })
    {
      EXPECT_EQ(failingCells(mesh, region), 0) << region;
      EXPECT_GT(smallestCell(mesh, region), 0.01 * size * size * size) << region;
    }
  }
}

// What walls have lost and what they owe is always the same together.
// A plate of a hundredth of a box, and a rod: nothing is left of them where their cells go.
TEST(WallImprovement, ThinBodiesStay)
{
  for (const Soup& body :
    { box({ 0, 0, 0.4 }, { 1, 0.8, 0.403 }), box({ 0, 0, 0 }, { 1, 0.01, 0.02 }) })
  {
    for (const Soup& soup : { body, body.turned() })
    {
      const Meshed meshed = meshInPlace({ "", soup, 0.3, 0 });
      EXPECT_TRUE(isValid(meshed.mesh, true));
      EXPECT_NEAR(volumeOf(meshed.mesh), soup.volume(), 1e-3 * soup.volume());
    }
  }
}

// More triangles in a few boxes than these can show: what they enclose is still there.
TEST(WallImprovement, CrowdedCellsAreThinned)
{
  Soup soup = box({ -1, -1, -1 }, { 1, 1, 1 });
  soup.boundary.clear();
  Soup hole = sphere(24, 0.05).moved({ 0.02, 0.03, 0.05 }).flipped();
  hole.boundary.clear();
  const double volume = -hole.volume();
  soup.add(hole);
  const Meshed meshed = meshInPlace({ "", soup, 2.0 / 15, 0 });
  EXPECT_TRUE(isValid(meshed.mesh, true));
  EXPECT_LT(volumeOf(meshed.mesh), 8 - volume / 4);
  EXPECT_LT(meshed.mesh.boundaryStart.size(), 2000U);
}

// They lie on one side of the wall in front of the faces that they stand on, whichever way edits turned these.
TEST(WallImprovement, LayersStandOnWallsOfRegions)
{
  Soup soup;
  soup.addRegion(box({ 0.25, 0.25, 0.375 }, { 0.75, 0.875, 0.625 })).addRegion(cube());
  TestOptions options = optionsInPlace({ "", soup, 0, 1 });
  options.grid = cellsAlongLongest(soup, 8);
  options.layers.count = 2;
  options.memoryLimit = PlentyOfMemory;
  Execution execution(options.threads);
  const auto assembly = mesh(soup.turned().view(), options, execution);
  const MeshArrays plain = arraysOf(*assembly->mesh, assembly->boxes, execution);
  const MeshArrays layered = withLayers(plain, *assembly->layers);
  EXPECT_GT(layered.cells(), plain.cells());
  EXPECT_TRUE(isValid(layered, true));
}

constexpr EditBlockSize BlocksAtOnce{ 8, 4, ~std::uint32_t(0) };

// Nodes slide along planes: nothing of the wall moves, and faces lie nearer to under the centres of their cells.
TEST(WallImprovement, WallsAreCentred)
{
  const TestOptions options = asTheyAre();
  Execution execution(1);
  const auto a = cutCellsOf(cube().turned(), cellsOf(0.13), options, execution);
  EditableWall wall =
    openWall({ a->boxes, a->patches, a->sides, a->nodes, a->wall }, {}, execution);
  EditMesh& whole = wall.mesh.mesh();
  const auto tangents = [&] { // by area
    double sum = 0;
    for (const EditFace& face : whole.faces)
    {
      if (!face.gone && face.above == None)
      {
        const Vector to = minus(face.centre, whole.cells[face.below].centre);
        const double height = dot(to, unit(face.area));
        sum += norm(face.area) * std::sqrt(std::max(0.0, dot(to, to) / (height * height) - 1));
      }
    }
    return sum;
  };
  const auto area = [&] {
    double sum = 0;
    for (const EditFace& face : whole.faces)
    {
      sum += face.gone || face.above != None ? 0 : norm(face.area);
    }
    return sum;
  };
  const ObjectiveSpec spec;
  costAll(whole, spec, execution);
  BlockEditing blocks(whole, execution);
  blocks.edit(BlocksAtOnce, [&](const ZoneTask& task) {
    simplifyWalls(task, SimplificationSpec(), { spec }, [] {});
    improve(task, LoopSpec(), [] {});
  });
  blocks.finish();
  const double tangentsBefore = tangents();
  const double areaBefore = area();
  centreWalls(whole, spec, execution);
  EXPECT_LT(tangents(), 0.9 * tangentsBefore);
  EXPECT_NEAR(area(), areaBefore, OffPlanes * areaBefore);
}

TEST(WallImprovement, DeficitsAreWhatTheVolumeLacks)
{
  const TestOptions options = asTheyAre();
  const Soup soup = torus(48, 1, 0.4).turned();
  Execution execution(1);
  const auto a = cutCellsOf(soup, cellsOf(0.13), options, execution);
  EditableWall wall =
    openWall({ a->boxes, a->patches, a->sides, a->nodes, a->wall }, {}, execution);
  EditMesh& whole = wall.mesh.mesh();
  const auto together = [&] {
    double sum = 0;
    for (const EditFace& face : whole.faces)
    {
      sum += face.gone || face.above != None ? 0 : face.behind + face.volumeDeficit;
    }
    return sum;
  };
  const LoopSpec spec;
  const auto poll = [] {};
  costAll(whole, spec.rules.objective, execution);
  const double before = together();
  BlockEditing blocks(whole, execution);
  blocks.edit(BlocksAtOnce, [&](const ZoneTask& task) {
    simplifyWalls(task, SimplificationSpec(), spec.rules, poll);
    snapEdges(task, spec.rules, SnapSpec(), poll);
  });
  EXPECT_NEAR(together(), before, 1e-9 * before);
  redistributeVolume(whole, spec.rules.objective, execution);
  EXPECT_NEAR(together(), before, 1e-9 * before);
  blocks.edit(BlocksAtOnce, [&](const ZoneTask& task) { improve(task, spec, poll); });
  EXPECT_NEAR(together(), before, 1e-9 * before);
}

}

}
