// The mesh at the wall as one that can be edited, and back.
#include "Editing/PrimitiveEdits.h"
#include "Editing/WallClosing.h"
#include "Support/MeshChecker.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <map>
#include <random>
#include <set>
#include <tuple>

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
    all.push_back({ "Ball" + name, ball, plain(levels > 1 ? 0.9 : 0.31, levels) });
    all.push_back({ "Cube" + name, cube().turned(), plain(levels > 1 ? 0.8 : 0.43, levels) });
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

std::unique_ptr<Assembly> cutCellsOf(const Case& one)
{
  Execution execution;
  return cutCellsOf(one.soup, one.options.grid, one.options, execution);
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

EditableWall opened(const Assembly& a)
{
  Execution execution;
  return openWall(partsOf(a), { FeatureAngle, nullptr }, execution);
}

void close(const EditableWall& edited, Assembly& a)
{
  Execution execution;
  a.wall.forgetFaces();
  closeWall(edited, a.boxes, a.patches.walls, a.sides, a.nodes, a.wall, execution);
}

class EditableWallOf : public ::testing::TestWithParam<Case>
{
};

// Each edge once in both directions.
bool isClosed(const MeshEditor& mesh, std::uint32_t c)
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

// Of two cells each; returns how many are gone.
std::size_t mergeSome(EditableWall& edited)
{
  MeshEditor& mesh = edited.mesh;
  std::mt19937 random(1);
  std::size_t merged = 0;
  const auto count = static_cast<std::uint32_t>(mesh.faceCount());
  const auto isSimple = [&](std::uint32_t c) {
    return mesh.isFree(c) && mesh.facesOf(c).size() < 20;
  };
  for (std::uint32_t f = 0; f < count; f += 1 + static_cast<std::uint32_t>(random() % 7))
  {
    const EditFace face = mesh.face(f);
    if (face.gone || face.above == None || !isSimple(face.below) || !isSimple(face.above))
    {
      continue;
    }
    const MeshEditor::Mark mark = mesh.mark();
    if (mergeCells(mesh, face.below, face.above) && isClosed(mesh, face.below))
    {
      mesh.commit();
      ++merged;
    }
    else
    {
      mesh.undo(mark);
    }
  }
  return merged;
}

// Nodes inside, and in sides, but not of small cells.
void moveSome(MeshEditor& mesh)
{
  constexpr double Little = 0.01;
  std::mt19937 random(1);
  const auto isLarge = [&](std::uint32_t c) {
    return c == None || mesh.cell(c).volume > 0.99 * mesh.cell(c).boxVolume;
  };
  for (std::uint32_t n = 0; n < mesh.nodeCount(); ++n)
  {
    const EditNode& node = mesh.node(n);
    const bool isInSide = node.constrainedAxes != 0 && node.kind == NodeKind::OnSurface;
    const Items faces = mesh.facesAround(n);
    if (!node.gone && random() % 4 == 0 && (isInSide || !node.atWall) &&
      std::all_of(faces.begin(), faces.end(), [&](std::uint32_t f) {
        return isLarge(mesh.face(f).below) && isLarge(mesh.face(f).above);
      }))
    {
      Vector to = node.at;
      for (std::size_t axis = 0; axis < 3; ++axis)
      {
        to[axis] += (node.constrainedAxes >> axis & 1) != 0 ? 0 : Little;
      }
      mesh.moveNode(n, onLattice(mesh, to, node.constrainedAxes));
    }
  }
  mesh.commit();
}

// The same surface, in another order.
Soup reversed(Soup soup)
{
  const auto count = static_cast<std::uint32_t>(soup.points.size());
  std::reverse(soup.points.begin(), soup.points.end());
  for (auto& [a, b, c] : soup.triangles)
  {
    a = count - 1 - a;
    b = count - 1 - b;
    c = count - 1 - c;
    std::swap(a, b);
    std::swap(b, c);
  }
  std::reverse(soup.triangles.begin(), soup.triangles.end());
  std::reverse(soup.boundary.begin(), soup.boundary.end());
  std::reverse(soup.region.begin(), soup.region.end());
  return soup;
}

}

TEST_P(EditableWallOf, CellsAreClosed)
{
  const auto a = cutCellsOf(GetParam());
  const EditableWall edited = opened(*a);
  const MeshEditor& mesh = edited.mesh;
  ASSERT_GT(edited.cells, 0u);
  double sum = 0;
  for (std::uint32_t c = 0; c < edited.cells; ++c)
  {
    EXPECT_EQ(isClosed(mesh, c), mesh.isFree(c)) << c;
    sum += mesh.cell(c).volume;
    const CellKey key = mesh.cell(c).number;
    EXPECT_NEAR(mesh.cell(c).volume / mesh.cell(c).boxVolume,
      isHexahedron(key) ? 1 : a->wall.cells[key].volumeFraction, 1e-9);
  }
  EXPECT_GT(sum, 0);
  for (std::uint32_t n = 1; n < mesh.nodeCount(); ++n)
  {
    ASSERT_LT(edited.placeOf(n - 1), edited.placeOf(n));
  }
  for (std::uint32_t f = 0; f < mesh.faceCount(); ++f)
  {
    const Items corners = mesh.cornersOf(f);
    const std::set<std::uint32_t> nodes(corners.begin(), corners.end());
    EXPECT_TRUE(nodes.size() == corners.size() || !mesh.isFree(mesh.face(f).below)) << f;
  }
}

TEST_P(EditableWallOf, NoEditsChangeNothing)
{
  const auto a = cutCellsOf(GetParam());
  const std::vector<Cell> before = a->wall.cells;
  const std::vector<std::uint32_t> polyhedral = a->sides.polyhedral;
  std::map<std::int32_t, double> patches;
  for (std::size_t p = 0; p < a->wall.faces.firstOfSides(); ++p)
  {
    // Patches of one region alone, of cells that stay.
    const CellKey cell = a->wall.faces.cells[p][0];
    if (cell != None && !a->wall.isRemoved(cell) && !a->patches.walls.any())
    {
      patches[a->wall.faces.boundary[p]] += 1;
    }
  }
  close(opened(*a), *a);
  EXPECT_EQ(a->sides.polyhedral, polyhedral);
  EXPECT_EQ(a->wall.faces.firstShaped, a->wall.faces.size());
  ASSERT_EQ(a->wall.cells.size(), before.size());
  for (std::size_t c = 0; c + 1 < before.size(); ++c)
  {
    const Cell& cell = a->wall.cells[c];
    EXPECT_EQ(std::tie(cell.box, cell.boundary, cell.region, cell.removed),
      std::tie(before[c].box, before[c].boundary, before[c].region, before[c].removed));
    EXPECT_NEAR(cell.volumeFraction, before[c].volumeFraction, 1e-9);
  }
  const MeshArrays after = written(*a);
  EXPECT_TRUE(isValid(after));
  std::map<std::int32_t, double> faces;
  for (const std::int32_t boundary : after.boundaryIndex)
  {
    faces[boundary] += 1;
  }
  for (const auto& [boundary, count] : patches)
  {
    EXPECT_GE(faces[boundary], count);
  }
}

// Faces that begin at another corner are new ones, of cells that have changed.
TEST_P(EditableWallOf, AllIsWritten)
{
  const auto plain = cutCellsOf(GetParam());
  close(opened(*plain), *plain);
  const MeshArrays before = written(*plain);
  const auto a = cutCellsOf(GetParam());
  EditableWall edited = opened(*a);
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

// Inner cells merge, nodes move: what is written is valid.
TEST_P(EditableWallOf, EditsAreWritten)
{
  const auto plain = cutCellsOf(GetParam());
  close(opened(*plain), *plain);
  const MeshArrays before = written(*plain);
  const auto a = cutCellsOf(GetParam());
  EditableWall edited = opened(*a);
  moveSome(edited.mesh);
  const std::size_t merged = mergeSome(edited);
  EXPECT_GT(merged, 0u);
  close(edited, *a);
  const MeshArrays after = written(*a);
  EXPECT_TRUE(isValid(after, true));
  EXPECT_EQ(after.cells() + merged, before.cells());
  EXPECT_NEAR(volumeOf(after), volumeOf(before), 1e-9 * volumeOf(before));
  const auto areas = areasByBoundary(after);
  for (const auto& [boundary, area] : areasByBoundary(before))
  {
    EXPECT_NEAR(areas.at(boundary), area, 1e-9 * (1 + area)) << boundary;
  }
}

// Nodes of sides slide in them; those of cells that are not edited stay.
TEST_P(EditableWallOf, NodesAreHeld)
{
  const auto a = cutCellsOf(GetParam());
  const EditableWall edited = opened(*a);
  const MeshEditor& mesh = edited.mesh;
  for (std::uint32_t f = 0; f < mesh.faceCount(); ++f)
  {
    const EditFace& face = mesh.face(f);
    for (const std::uint32_t n : mesh.cornersOf(f))
    {
      const std::uint8_t held = mesh.node(n).constrainedAxes;
      if (face.above != None && mesh.isGhost(face.above))
      {
        EXPECT_EQ(held, AllAxes);
      }
      else if (isWallOfEnd(face.wall))
      {
        const auto axis = static_cast<std::size_t>(face.wall - wallOfEnd(0)) / 2;
        const auto& planes = a->boxes.planes[axis];
        const Level level = edited.placeOf(n)[axis];
        EXPECT_TRUE(held >> axis & 1);
        EXPECT_TRUE(level == planes.front() || level == planes.back());
      }
    }
  }
}

TEST(EditableWall, KindsOfNodesOfACube)
{
  const auto a = cutCellsOf(Case{ "", cube().turned(), plain(0.23, 0) });
  const EditableWall edited = opened(*a);
  std::map<NodeKind, int> kinds;
  for (std::uint32_t n = 0; n < edited.mesh.nodeCount(); ++n)
  {
    const EditNode& node = edited.mesh.node(n);
    ++kinds[node.kind];
    EXPECT_EQ(node.kind == NodeKind::Free, !node.atWall);
    if (node.kind == NodeKind::OnSurface)
    {
      EXPECT_NEAR(norm(node.along), 1, 1e-9);
      EXPECT_GT(node.maxDisplacement, 0.3F);
    }
  }
  EXPECT_EQ(kinds[NodeKind::Corner], 8);
  EXPECT_GT(kinds[NodeKind::OnEdge], 12);
}

TEST(EditableWall, IsTheSameForAnyOrder)
{
  for (const Case& one : cases())
  {
    SCOPED_TRACE(one.name);
    const auto a = cutCellsOf(one);
    const auto b = cutCellsOf(Case{ "", reversed(one.soup), one.options });
    const EditableWall x = opened(*a);
    const EditableWall y = opened(*b);
    ASSERT_EQ(x.mesh.faceCount(), y.mesh.faceCount());
    ASSERT_EQ(x.mesh.nodeCount(), y.mesh.nodeCount());
    ASSERT_EQ(x.mesh.cellCount(), y.mesh.cellCount());
    for (std::uint32_t n = 0; n < x.mesh.nodeCount(); ++n)
    {
      const EditNode& p = x.mesh.node(n);
      const EditNode& q = y.mesh.node(n);
      ASSERT_EQ(std::tie(p.at, p.kind, p.along, p.maxDisplacement, p.constrainedAxes, p.atWall),
        std::tie(q.at, q.kind, q.along, q.maxDisplacement, q.constrainedAxes, q.atWall));
    }
    for (std::uint32_t f = 0; f < x.mesh.faceCount(); ++f)
    {
      const EditFace& p = x.mesh.face(f);
      const EditFace& q = y.mesh.face(f);
      ASSERT_EQ(std::tie(p.area, p.volumeDeficit, p.wall, p.cost, p.below, p.above),
        std::tie(q.area, q.volumeDeficit, q.wall, q.cost, q.below, q.above));
      const Items ofX = x.mesh.cornersOf(f);
      const Items ofY = y.mesh.cornersOf(f);
      ASSERT_TRUE(std::equal(ofX.begin(), ofX.end(), ofY.begin(), ofY.end()));
    }
    for (std::uint32_t c = 0; c < x.mesh.cellCount(); ++c)
    {
      const EditCell& p = x.mesh.cell(c);
      const EditCell& q = y.mesh.cell(c);
      ASSERT_EQ(std::tie(p.boxIndex, p.volume, p.wall, p.region, p.cost),
        std::tie(q.boxIndex, q.volume, q.wall, q.region, q.cost));
    }
  }
}

INSTANTIATE_TEST_SUITE_P(
  All, EditableWallOf, ::testing::ValuesIn(cases()), [](const auto& of) { return of.param.name; });

}
