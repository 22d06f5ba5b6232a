// The mesh at the wall as one that can be edited, and back.
#include "Editing/EditMeasures.h"
#include "Editing/EditableWall.h"
#include "Editing/PrimitiveEdits.h"
#include "Support/MeshChecker.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <map>

namespace cartesian
{

namespace
{

constexpr double FeatureAngle = 30;
constexpr int FirstSide = 10;

struct Case
{
  std::string name;
  Soup soup;
  TestOptions options;
};

std::ostream& operator<<(std::ostream& stream, const Case& one)
{
  return stream << one.name;
}

TestOptions plain(double size, int levels, double smallCells = 0)
{
  TestOptions options = asTheyAre(smallCells, depth(levels));
  options.grid = cellsOf(size);
  options.memoryLimit = PlentyOfMemory;
  return options;
}

TestOptions around(TestOptions options, Half half = Half::Whole)
{
  options.domain.domain = Domain::Outside;
  options.domain.boxFrom = BoxSource::Bounds;
  options.domain.bounds = { { -1, -1, -1 }, { 2, 2, 2 } };
  options.domain.half = half;
  for (std::size_t side = 0; side < 6; ++side)
  {
    options.domain.sides[side] = FirstSide + static_cast<int>(side);
  }
  return options;
}

std::vector<Case> cases()
{
  std::vector<Case> all;
  const Soup ball = sphere(6, 0.7);
  for (int levels = 0; levels <= 3; ++levels)
  {
    const std::string name = std::to_string(levels);
    all.push_back({ "Ball" + name, ball, plain(0.31, levels) });
    all.push_back({ "Cube" + name, cube().turned(), plain(0.43, levels) });
  }
  TestOptions atBoundary = plain(0.4, 0);
  atBoundary.refinement.sizing.curvatureAngle = 20;
  all.push_back({ "Curved", torus(12, 1, 0.4), atBoundary });
  all.push_back({ "Around", ball, around(plain(0.31, 1)) });
  all.push_back({ "Half", ball, around(plain(0.31, 1), Half::AcrossY) });
  all.push_back(
    { "HalfTurned", cube().turned().scaled(0.5), around(plain(0.2, 0), Half::AcrossX) });
  all.push_back({ "SmallCells", ball.turned(), plain(0.23, 0, 0.2) });
  all.push_back({ "SmallCellsBelow", ball.turned(), plain(0.43, 2, 0.2) });
  Soup regions;
  regions.addRegion(box({ 0, 0, 0 }, { 1, 1, 1 })).addRegion(box({ 1, 0, 0 }, { 2, 1, 1 }));
  all.push_back({ "Regions", regions.turned(), plain(0.31, 1) });
  all.push_back({ "Voids", nestedSpheres(), plain(nestedSpheres().longest() / 7, 0) });
  all.push_back({ "Comb", comb(4), plain(comb(4).longest() / 9, 1) });
  for (Case& one : all)
  {
    one.options.regionsFrom = one.soup.region.empty() ? RegionSource::One : RegionSource::Blocks;
  }
  return all;
}

std::unique_ptr<Assembly> assembledOf(const Case& one)
{
  Execution execution;
  const PreparedSurface prepared = prepareSurface(one.soup.view(), one.options, execution);
  const auto decomposition = decompose(prepared, one.options, execution);
  return meshPart(prepared, *decomposition, decomposition->allLayers(), one.options, execution);
}

MeshParts partsOf(const Assembly& a)
{
  return { a.boxes, a.patches, a.sides, a.nodes, a.wall };
}

MeshArrays written(Assembly& a)
{
  Execution execution;
  a.mesh = std::make_unique<OutputMesh>(partsOf(a), execution);
  return arraysOf(*a.mesh, a.boxes, execution);
}

void close(const EditableWall& edited, Assembly& a)
{
  Execution execution;
  closeWall(edited, a.boxes, a.sides, a.nodes, a.wall, execution);
}

class EditableWallOf : public ::testing::TestWithParam<Case>
{
};

// Each edge once in both directions.
bool isClosed(const EditMesh& mesh, std::uint32_t c)
{
  std::map<std::pair<std::uint32_t, std::uint32_t>, int> edges;
  for (const std::uint32_t f : mesh.facesOf(c))
  {
    const Items corners = mesh.cornersOf(f);
    for (std::size_t i = 0; i < corners.size(); ++i)
    {
      std::pair<std::uint32_t, std::uint32_t> edge{ corners[i], corners[(i + 1) % corners.size()] };
      if (mesh.face(f).below != c)
      {
        std::swap(edge.first, edge.second);
      }
      ++edges[edge];
    }
  }
  return std::all_of(edges.begin(), edges.end(), [&](const auto& entry) {
    const auto back = edges.find({ entry.first.second, entry.first.first });
    return entry.second == 1 && back != edges.end() && back->second == 1;
  });
}

}

TEST_P(EditableWallOf, CellsAreClosed)
{
  const auto a = assembledOf(GetParam());
  const EditableWall edited = openWall(partsOf(*a), FeatureAngle);
  const EditMesh& mesh = edited.mesh;
  ASSERT_GT(edited.opened.cells, 0u);
  double sum = 0;
  for (std::uint32_t c = 0; c < edited.opened.cells; ++c)
  {
    ASSERT_EQ(mesh.cell(c).state, CellState::Free);
    EXPECT_TRUE(isClosed(mesh, c)) << c;
    sum += mesh.cell(c).volume;
    const CellKey key = mesh.cell(c).number;
    EXPECT_NEAR(mesh.cell(c).volume / mesh.cell(c).box,
      isHexahedron(key) ? 1 : a->wall.cells[key].volumeFraction, 1e-9);
  }
  EXPECT_GT(sum, 0);
  for (std::uint32_t f = 0; f < mesh.faceCount(); ++f)
  {
    EXPECT_FALSE(mesh.isGhost(mesh.face(f).below));
  }
}

TEST_P(EditableWallOf, NoEditsChangeNothing)
{
  const auto a = assembledOf(GetParam());
  const MeshArrays before = written(*a);
  close(openWall(partsOf(*a), FeatureAngle), *a);
  EXPECT_TRUE(written(*a) == before);
}

// Faces that begin at another corner are new ones, of cells that have changed.
TEST_P(EditableWallOf, AllIsWritten)
{
  const auto a = assembledOf(GetParam());
  const MeshArrays before = written(*a);
  EditableWall edited = openWall(partsOf(*a), FeatureAngle);
  for (std::uint32_t f = 0; f < edited.mesh.faceCount(); ++f)
  {
    const Items corners = edited.mesh.cornersOf(f);
    const std::uint32_t above = edited.mesh.face(f).above;
    if (above == None || !edited.mesh.isGhost(above))
    {
      std::vector<std::uint32_t> turned(corners.begin(), corners.end());
      std::rotate(turned.begin(), turned.begin() + 1, turned.end());
      edited.mesh.setCorners(f, turned.data(), turned.size());
    }
  }
  close(edited, *a);
  const MeshArrays after = written(*a);
  EXPECT_TRUE(isValid(before));
  EXPECT_TRUE(isValid(after));
  EXPECT_EQ(after.cells(), before.cells());
  EXPECT_EQ(after.points.size(), before.points.size());
  EXPECT_EQ(after.globalBox, before.globalBox);
  EXPECT_EQ(after.region, before.region);
  EXPECT_EQ(after.boundaryIndex.size(), before.boundaryIndex.size());
  for (std::size_t c = 0; c < before.cells(); ++c)
  {
    ASSERT_NEAR(after.volumeFraction[c], before.volumeFraction[c], 1e-9) << c;
  }
  const auto areas = areasByBoundary(after);
  const auto areasBefore = areasByBoundary(before);
  ASSERT_EQ(areas.size(), areasBefore.size());
  for (const auto& [boundary, area] : areasBefore)
  {
    EXPECT_NEAR(areas.at(boundary), area, 1e-9 * (1 + area)) << boundary;
  }
}

INSTANTIATE_TEST_SUITE_P(
  All, EditableWallOf, ::testing::ValuesIn(cases()), [](const auto& of) { return of.param.name; });

}
