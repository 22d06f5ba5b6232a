// What is proposed for faces and cells of meshes of boxes.
#include "Editing/Proposals.h"
#include "Support/Turned.h"

#include <gtest/gtest.h>

#include <map>

namespace cartesian
{

namespace
{

using Pair = std::pair<std::uint32_t, std::uint32_t>;
using Pairs = std::vector<Pair>;

// 3 x 3 x 2 boxes: the upper ones are so high.
std::function<Vector(const Vector&)> withThinTop(double height)
{
  return [height](const Vector& p) { return Vector{ p[0], p[1], p[2] < 2 ? p[2] : 1 + height }; };
}

MeshEditor thinTop(double height)
{
  return meshOfBoxes(blockOfBoxes(3, 3, 2), { withThinTop(height) });
}

constexpr std::uint32_t Top = 9; // in the middle
constexpr std::uint32_t Below = 8;

Proposals forCell(const MeshView& mesh, std::uint32_t c, const SearchSpec& search = {})
{
  Proposals proposals;
  proposeForCell(mesh, search, c, proposals);
  return proposals;
}

Proposals forFace(const MeshView& mesh, std::uint32_t f, const SearchSpec& search = {})
{
  Proposals proposals;
  proposeForFace(mesh, search, f, proposals);
  return proposals;
}

Pairs pairsOf(const Proposals& proposals, EditKind kind)
{
  Pairs pairs;
  for (const Proposal& proposal : proposals)
  {
    if (proposal.kind == kind)
    {
      pairs.emplace_back(proposal.a, proposal.b);
    }
  }
  return pairs;
}

std::map<EditKind, std::size_t> countsOf(const Proposals& proposals)
{
  std::map<EditKind, std::size_t> counts;
  for (const Proposal& proposal : proposals)
  {
    ++counts[proposal.kind];
  }
  return counts;
}

std::vector<std::uint32_t> neighboursOf(const MeshView& mesh, std::uint32_t c)
{
  const Neighbours neighbours = largestNeighbours(mesh, c);
  return { neighbours.begin(), neighbours.end() };
}

SearchSpec removing(double share)
{
  SearchSpec search;
  search.removedShare = share;
  return search;
}

bool isRemoved(const MeshView& mesh, std::uint32_t c, double share)
{
  return pairsOf(forCell(mesh, c, removing(share)), EditKind::Remove) == Pairs{ { c, 0 } };
}

}

// --- largestNeighbours

// The middle one of 3 x 3 x 3 is 4 x 2 x 1: its sides have areas of 2, 4 and 8.
TEST(LargestNeighbours, ByAreaThenByNumber)
{
  constexpr std::array<std::array<double, 4>, 3> At{ { { 0, 1, 5, 6 }, { 0, 1, 3, 4 },
    { 0, 1, 2, 3 } } };
  for (const Turn& turn : turns())
  {
    MeshEditor mesh = turnedMesh(turn, blockOfBoxes(3, 3, 3), [&](const Vector& p) {
      return Vector{ At[0][std::size_t(p[0])], At[1][std::size_t(p[1])], At[2][std::size_t(p[2])] };
    });
    const std::uint32_t middle = cellAt(mesh, turn({ 3, 2, 1.5 }));
    std::vector<std::uint32_t> expected;
    for (const Vector& by : { Vector{ 0, 0, 1 }, { 0, 1.5, 0 }, { 2.5, 0, 0 } })
    {
      const std::uint32_t one = cellAt(mesh, turn(plus({ 3, 2, 1.5 }, by)));
      const std::uint32_t other = cellAt(mesh, turn(minus(Vector{ 3, 2, 1.5 }, by)));
      expected.push_back(std::min(one, other));
      expected.push_back(std::max(one, other));
    }
    EXPECT_EQ(neighboursOf(mesh, middle), expected);
    // Those that may not change are no neighbours to merge with.
    mesh.rawCell(expected[1]).state = CellState::Frozen;
    mesh.rawCell(expected[2]).zone = 1;
    EXPECT_EQ(neighboursOf(mesh, middle),
      (std::vector<std::uint32_t>{ expected[0], expected[3], expected[4], expected[5] }));
  }
}

TEST(LargestNeighbours, AddsUpAllFacesToOne)
{
  MeshEditor mesh = meshOfBoxes(hangingBoxes());
  EXPECT_EQ(neighboursOf(mesh, 0), (std::vector<std::uint32_t>{ 1, 2, 3, 4 }));
  ASSERT_TRUE(mergeCells(mesh, 3, 4));
  mesh.commit();
  measureAgain(mesh);
  EXPECT_EQ(neighboursOf(mesh, 0), (std::vector<std::uint32_t>{ 3, 1, 2 }));
  EXPECT_EQ(neighboursOf(mesh, 3), (std::vector<std::uint32_t>{ 0, 1, 2 }));
}

// --- merges

TEST(Proposals, OfACellAreItsMergesOnceEach)
{
  const MeshEditor mesh =
    meshOfBoxes(blockOfBoxes(3, 3, 3), { [](const Vector& p) { return scaled(p, 0.875); } });
  EXPECT_EQ(
    countsOf(forCell(mesh, 13)), (std::map<EditKind, std::size_t>{ { EditKind::Merge, 6 } }));
  EXPECT_EQ(pairsOf(forCell(mesh, 13), EditKind::Merge),
    (Pairs{ { 4, 13 }, { 10, 13 }, { 12, 13 }, { 13, 14 }, { 13, 16 }, { 13, 22 } }));
  EXPECT_EQ(pairsOf(forCell(mesh, 0), EditKind::Merge), (Pairs{ { 0, 1 }, { 0, 3 }, { 0, 9 } }));
}

// Whichever has the lower number.
TEST(Proposals, TheCellOfMoreFacesStays)
{
  std::vector<TestBox> boxes = hangingBoxes();
  std::swap(boxes.front(), boxes.back()); // cell 4 is the large one
  const MeshEditor mesh = meshOfBoxes(boxes, { [](const Vector& p) { return scaled(p, 0.875); } });
  EXPECT_EQ(
    pairsOf(forCell(mesh, 4), EditKind::Merge), (Pairs{ { 4, 0 }, { 4, 1 }, { 4, 2 }, { 4, 3 } }));
  EXPECT_EQ(pairsOf(forCell(mesh, 0), EditKind::Merge), (Pairs{ { 0, 2 }, { 0, 3 }, { 4, 0 } }));
}

// Two boxes' volumes, and more, are too much for one cell; and nothing else is wrong with boxes.
TEST(Proposals, NoneForLargeBoxes)
{
  const MeshEditor mesh =
    meshOfBoxes(blockOfBoxes(3, 2, 2), { [](const Vector& p) { return scaled(p, 1.25); } });
  for (std::uint32_t c = 0; c < mesh.cellCount(); ++c)
  {
    EXPECT_TRUE(forCell(mesh, c, removing(1)).empty()) << c;
  }
  for (std::uint32_t f = 0; f < mesh.faceCount(); ++f)
  {
    EXPECT_TRUE(forFace(mesh, f, removing(1)).empty()) << f;
  }
}

TEST(Proposals, NoMergesAcrossRegions)
{
  std::vector<TestBox> boxes = blockOfBoxes(3, 1, 1);
  boxes[2].region = 1;
  const MeshEditor mesh = meshOfBoxes(boxes, { [](const Vector& p) { return scaled(p, 0.875); } });
  EXPECT_EQ(pairsOf(forCell(mesh, 1), EditKind::Merge), (Pairs{ { 0, 1 } }));
  EXPECT_TRUE(forCell(mesh, 2).empty());
}

// --- removal

TEST(Proposals, RemoveSmallCellsOnly)
{
  const MeshEditor mesh = thinTop(1.0 / 64);
  EXPECT_TRUE(isRemoved(mesh, Top, 1.0 / 32));
  EXPECT_FALSE(isRemoved(mesh, Top, 1.0 / 65));
  EXPECT_FALSE(isRemoved(mesh, Below, 1.0 / 32));
  EXPECT_FALSE(isRemoved(mesh, Top, 0));
}

// A cell of a face that is bad may be larger than one that was not asked about.
TEST(Proposals, RemoveLargerCellsOfFacesOnly)
{
  const MeshEditor mesh = thinTop(1.0 / 16);
  EXPECT_FALSE(isRemoved(mesh, Top, 0.125));
  const Proposals proposals = forFace(mesh, wallOf(mesh, Top, 5), removing(0.125));
  EXPECT_EQ(pairsOf(proposals, EditKind::Remove), (Pairs{ { Top, 0 } }));
  EXPECT_TRUE(
    pairsOf(forFace(mesh, wallOf(mesh, Top, 5), removing(1.0 / 17)), EditKind::Remove).empty());
}

TEST(CouldRemove, AtAWallAtNoOtherRegion)
{
  EXPECT_TRUE(couldRemove(thinTop(1.0 / 64), Top));
  std::vector<TestBox> boxes = blockOfBoxes(3, 3, 2);
  boxes[Top + 2].region = 1; // beside it
  EXPECT_FALSE(couldRemove(meshOfBoxes(boxes, { withThinTop(1.0 / 64) }), Top));
  EXPECT_FALSE(couldRemove(meshOfBoxes(blockOfBoxes(3, 3, 3)), 13)); // inside
}

TEST(CouldRemove, NotWhereTheBodyIsAsThin)
{
  const MeshEditor mesh = meshOfBoxes(blockOfBoxes(3, 3, 1), { [](const Vector& p) {
    return Vector{ p[0], p[1], p[2] / 64 };
  } });
  EXPECT_FALSE(couldRemove(mesh, 4));
}

TEST(CouldRemove, NotABridge)
{
  const MeshEditor mesh = meshOfBoxes(blockOfBoxes(3, 1, 1), { [](const Vector& p) {
    return Vector{ p[0] < 2 ? p[0] : p[0] - 0.75, p[1], p[2] };
  } });
  EXPECT_FALSE(couldRemove(mesh, 1));
  EXPECT_TRUE(couldRemove(mesh, 0));
}

TEST(CouldRemove, ByTheBoundarysOwnRatio)
{
  MeshEditor mesh = thinTop(1.0 / 64);
  mesh.rawCell(Top).wall = 5;
  mesh.mesh().small.boundaryRatios = { { 4, 0 }, { 5, 1.0 / 65 } };
  EXPECT_FALSE(couldRemove(mesh, Top));
  mesh.mesh().small.boundaryRatios = { { 4, 0 }, { 5, 1.0 / 32 } };
  EXPECT_TRUE(couldRemove(mesh, Top));
}

// --- joins

TEST(CouldJoin, WallsThatTurnByLessThan60Degrees)
{
  for (const double depth : { 0.0, 0.5, 0.625 }) // 0, 53 and 64 degrees
  {
    const MeshEditor mesh = dentedCell(depth);
    Pairs walls;
    for (const std::uint32_t f : mesh.facesOf(0))
    {
      for (const std::uint32_t g : mesh.facesOf(0))
      {
        if (f < g && mesh.face(f).wall == 5 && mesh.face(g).wall == 5)
        {
          walls.emplace_back(f, g);
        }
      }
    }
    ASSERT_EQ(walls.size(), 1U);
    const auto [f, g] = walls[0];
    EXPECT_EQ(couldJoin(mesh, f, g, 0), depth < 0.6);
    EXPECT_EQ(pairsOf(forFace(mesh, f), EditKind::Join), depth < 0.6 ? Pairs{ walls[0] } : Pairs());
  }
}

TEST(CouldJoin, FacesBetweenTheSameCellsOnly)
{
  MeshEditor mesh = meshOfBoxes(hangingBoxes());
  const std::array<std::uint32_t, 4> faces{ faceBetween(mesh, 0, 1), faceBetween(mesh, 0, 2),
    faceBetween(mesh, 0, 3), faceBetween(mesh, 0, 4) };
  EXPECT_FALSE(couldJoin(mesh, faces[2], faces[3], 0));
  ASSERT_TRUE(mergeCells(mesh, 3, 4));
  mesh.commit();
  measureAgain(mesh);
  EXPECT_TRUE(couldJoin(mesh, faces[2], faces[3], 0));
  EXPECT_FALSE(couldJoin(mesh, faces[1], faces[3], 0));
  EXPECT_FALSE(couldJoin(mesh, wallOf(mesh, 0, 4), wallOf(mesh, 0, 2), 0)); // other walls
}

// --- collapses

// Nodes inside become those on the surface, where these are; never the other way.
TEST(Proposals, CollapseShortEdgesTowardsTheSurface)
{
  for (const Turn& turn : turns())
  {
    const MeshEditor mesh = turnedMesh(turn, blockOfBoxes(3, 3, 2), withThinTop(1.0 / 64));
    const std::uint32_t top = cellAt(mesh, turn({ 1.5, 1.5, 1 + 1.0 / 128 }));
    const std::uint32_t beside = cellAt(mesh, turn({ 2.5, 1.5, 1 + 1.0 / 128 }));
    const Proposals proposals = forFace(mesh, faceBetween(mesh, top, beside));
    std::size_t count = 0;
    for (const Proposal& proposal : proposals)
    {
      if (proposal.kind == EditKind::Collapse)
      {
        ++count;
        EXPECT_FALSE(mesh.node(proposal.a).atWall);
        EXPECT_TRUE(mesh.node(proposal.b).atWall);
        EXPECT_EQ(proposal.at, mesh.node(proposal.b).at);
      }
    }
    EXPECT_EQ(count, 2U);
    SearchSpec search;
    search.edges = 1;
    EXPECT_EQ(
      pairsOf(forFace(mesh, faceBetween(mesh, top, beside), search), EditKind::Collapse).size(),
      1U);
    search.edges = 3;
    search.longestEdge = 1.0 / 128;
    EXPECT_TRUE(
      pairsOf(forFace(mesh, faceBetween(mesh, top, beside), search), EditKind::Collapse).empty());
  }
}

// All that is proposed for a cell is of these kinds, along whichever axes it lies.
TEST(Proposals, OfACellDoNotDependOnAxes)
{
  for (const Turn& turn : turns())
  {
    const MeshEditor mesh = turnedMesh(turn, blockOfBoxes(3, 3, 2), withThinTop(1.0 / 64));
    auto counts =
      countsOf(forCell(mesh, cellAt(mesh, turn({ 1.5, 1.5, 1 + 1.0 / 128 })), removing(1.0 / 32)));
    EXPECT_EQ(counts[EditKind::Merge], 5U);
    EXPECT_EQ(counts[EditKind::Remove], 1U);
    EXPECT_LE(counts[EditKind::Collapse], 4U); // the upright edges
    EXPECT_EQ(counts.size(), 3U);
  }
}

// Nodes of one kind: the middle, and either way, unless they are next to each other.
TEST(Proposals, CollapseNodesOfAKindToTheirMiddle)
{
  for (const double length : { 0.125, 0.03125 })
  {
    for (const Turn& turn : turns())
    {
      const MeshEditor mesh = turnedMesh(turn, blockOfBoxes(3, 1, 1), [&](const Vector& p) {
        return Vector{ p[0] < 2 ? p[0] : p[0] - 1 + length, p[1], p[2] };
      });
      const Proposals proposals = forCell(mesh, cellAt(mesh, turn({ 1 + length / 2, 0.5, 0.5 })));
      std::map<std::size_t, std::size_t> counts; // at how many eighths of an edge
      for (const Proposal& proposal : proposals)
      {
        if (proposal.kind == EditKind::Collapse)
        {
          const double from = norm(minus(proposal.at, mesh.node(proposal.a).at));
          ++counts[static_cast<std::size_t>(std::lround(8 * from / length))];
        }
      }
      EXPECT_EQ(counts,
        length < 0.05 ? (std::map<std::size_t, std::size_t>{ { 4, 4 } })
                      : (std::map<std::size_t, std::size_t>{ { 4, 4 }, { 8, 8 } }));
    }
  }
}

// --- cuts

// An L: through the edge inside of it, between its walls there.
TEST(Proposals, CutFailingCellsAtTheirReentrantEdges)
{
  MeshEditor mesh = cellOfBoxes(
    { { { 0, 0, 0 }, { 1, 1, 1 } }, { { 1, 0, 0 }, { 2, 1, 1 } }, { { 0, 1, 0 }, { 1, 2, 1 } } });
  const std::uint32_t f = wallOf(mesh, 0, 0);
  SearchSpec search;
  search.cutsFailing = true;
  EXPECT_TRUE(pairsOf(forFace(mesh, f, search), EditKind::Flatten).empty());
  mesh.rawFace(f).fails = 1;
  EXPECT_EQ(pairsOf(forFace(mesh, f, search), EditKind::Flatten), (Pairs{ { f, 0 } }));
  for (const bool isAlong : { false, true })
  {
    search.cutsAlongFaces = isAlong;
    std::vector<Vector> normals;
    for (const Proposal& proposal : forFace(mesh, f, search))
    {
      if (proposal.kind == EditKind::Cut && proposal.at == Vector{ 1, 1, 0.5 })
      {
        normals.push_back(proposal.normal);
      }
    }
    ASSERT_EQ(normals.size(), isAlong ? 3U : 1U);
    const auto isDiagonal = [](const Vector& normal) {
      return normal[0] * normal[1] < 0 && std::abs(normal[0] + normal[1]) < 1e-15 && normal[2] == 0;
    };
    EXPECT_EQ(std::count_if(normals.begin(), normals.end(), isDiagonal), 1);
  }
}

}
