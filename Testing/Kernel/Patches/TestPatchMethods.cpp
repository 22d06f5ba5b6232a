// Automatic patches: Marching Cubes and Exact Fit side by side, tied and simplified (4.7, 4.8, A2).
#include "Base/Error.h"
#include "Patches/PatchChoice.h"
#include "Support/Effort.h"
#include "Support/MeshChecker.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <set>

using namespace cartesian;

namespace
{

TestOptions by(PatchMethod method, int levels = 0, Tying tying = Tying::KeepNodes)
{
  TestOptions options = asTheyAre();
  options.patches.method = method;
  options.patches.tying = tying;
  options.refinement = depth(levels);
  return options;
}

Vector at(const Meshed& meshed, std::size_t corner)
{
  const Point& p = meshed.patches.points[meshed.patches.corners[corner]];
  const Lattice& lattice = meshed.boxed.boxes.lattice;
  return { lattice.position(0, p[0]), lattice.position(1, p[1]), lattice.position(2, p[2]) };
}

Vector areaVector(const Meshed& meshed, std::size_t patch)
{
  const std::size_t begin = meshed.patches.start[patch];
  const std::size_t end = meshed.patches.start[patch + 1];
  Vector sum{ 0, 0, 0 };
  for (std::size_t c = begin + 1; c + 1 < end; ++c)
  {
    sum = plus(sum,
      cross(minus(at(meshed, c), at(meshed, begin)), minus(at(meshed, c + 1), at(meshed, begin))));
  }
  return { sum[0] / 2, sum[1] / 2, sum[2] / 2 };
}

void expectWatertight(const Patches& patches)
{
  std::map<std::pair<std::uint32_t, std::uint32_t>, int> sums;
  for (std::size_t p = 0; p < patches.size(); ++p)
  {
    std::uint32_t from = patches.corners[patches.start[p + 1] - 1];
    for (std::size_t c = patches.start[p]; c < patches.start[p + 1]; ++c)
    {
      const std::uint32_t to = patches.corners[c];
      sums[std::minmax(from, to)] += from < to ? 1 : -1;
      from = to;
    }
  }
  for (const auto& [edge, sum] : sums)
  {
    ASSERT_EQ(sum, 0) << edge.first << " to " << edge.second;
  }
}

// No star triangle is turned over, no edge is shorter than a millionth of the box.
void expectSoundFaces(const Meshed& meshed)
{
  const Patches& patches = meshed.patches;
  Execution execution;
  const std::vector<std::uint32_t> intersected = intersectedBoxes(meshed.boxed.boxes, execution);
  for (std::size_t n = 0; n < intersected.size(); ++n)
  {
    const Box box = meshed.boxed.boxes.box(intersected[n]);
    const Level size =
      std::max({ box.high[0] - box.low[0], box.high[1] - box.low[1], box.high[2] - box.low[2] });
    for (std::size_t p = patches.boxStart[n]; p < patches.boxStart[n + 1]; ++p)
    {
      const std::size_t begin = patches.start[p];
      const std::size_t end = patches.start[p + 1];
      Vector centre{ 0, 0, 0 };
      for (std::size_t c = begin; c < end; ++c)
      {
        const Vector x = at(meshed, c);
        centre = plus(centre,
          { x[0] / double(end - begin), x[1] / double(end - begin), x[2] / double(end - begin) });
      }
      const Vector normal = areaVector(meshed, p);
      for (std::size_t c = begin; c < end; ++c)
      {
        const std::size_t next = c + 1 < end ? c + 1 : begin;
        const Vector star = cross(minus(at(meshed, c), centre), minus(at(meshed, next), centre));
        EXPECT_GE(dot(star, normal), -1e-9 * dot(normal, normal)) << "patch " << p;
        const Vector edge =
          minus(patches.points[patches.corners[next]], patches.points[patches.corners[c]]);
        EXPECT_GE(std::sqrt(dot(edge, edge)), 1e-6 * size) << "patch " << p;
      }
    }
  }
}

class PatchesBy : public ::testing::TestWithParam<NamedShape>
{
};

// Surfaces of planes that meet at sharp edges.
std::vector<NamedShape> sharpShapes()
{
  return { { "Cube", cube().turned() }, { "Octahedron", octahedron(1).turned(2, 20) },
    { "BlockWithTubes", blockWithTubes().turned() }, { "Comb", comb(3).turned() },
    { "CubeOnMeshlines", cube() } };
}

std::vector<NamedShape> smoothShapes()
{
  return { { "Sphere", sphere(40, 1) }, { "Torus", torus(60, 1, 0.4) },
    { "BumpySphere", bumpySphere(3, 40) } };
}

class SharpShape : public ::testing::TestWithParam<NamedShape>
{
};

class SmoothShape : public ::testing::TestWithParam<NamedShape>
{
};

// A block with a thin fold in the middle of its upper face, which overlaps itself by 0.001.
Soup foldedBlock()
{
  const double fold = 0.001;
  Soup soup = box({ -2.5, -2.5, -2.5 }, { 2.5, 2.5, 2.5 });
  soup.boundary.clear();
  // The upper face anew: up to x = 0.5 + fold, back to 0.5, and on.
  std::vector<std::array<std::uint32_t, 3>> others;
  for (const auto& t : soup.triangles)
  {
    const bool upper =
      soup.points[t[0]][2] > 2 && soup.points[t[1]][2] > 2 && soup.points[t[2]][2] > 2;
    if (!upper)
    {
      others.push_back(t);
    }
  }
  soup.triangles = others;
  const auto add = [&](double x0, double x1, double z0, double z1) {
    const auto first = static_cast<std::uint32_t>(soup.points.size());
    soup.points.insert(
      soup.points.end(), { { x0, -2.5, z0 }, { x1, -2.5, z1 }, { x1, 2.5, z1 }, { x0, 2.5, z0 } });
    soup.triangles.push_back({ first, first + 1, first + 2 });
    soup.triangles.push_back({ first, first + 2, first + 3 });
  };
  add(-2.5, 0.5 + fold, 2.5, 2.5);
  add(0.5 + fold, 0.5 - fold, 2.5, 2.5 + fold / 10);
  add(0.5 - fold, 2.5, 2.5 + fold / 10, 2.5);
  // The two ends of the fold, where the sides of the block meet it.
  const auto close = [&](double y, bool front) {
    const auto first = static_cast<std::uint32_t>(soup.points.size());
    soup.points.insert(soup.points.end(),
      { { -2.5, y, 2.5 }, { 0.5 + fold, y, 2.5 }, { 0.5 - fold, y, 2.5 + fold / 10 },
        { 2.5, y, 2.5 } });
    const std::array<std::uint32_t, 3> a = { first, first + 3, first + 1 };
    const std::array<std::uint32_t, 3> b = { first + 1, first + 3, first + 2 };
    for (const auto& t : { a, b })
    {
      soup.triangles.push_back(front ? t : std::array<std::uint32_t, 3>{ t[0], t[2], t[1] });
    }
  };
  close(-2.5, true);
  close(2.5, false);
  return soup;
}

}

TEST_P(PatchesBy, AnyMethodAreWatertightAndGiveValidCells)
{
  const Soup& soup = GetParam().soup;
  for (const double cells : { 3.0, 6.2 })
  {
    for (const int levels : { 0, 2 })
    {
      for (const TestOptions& options :
        { by(PatchMethod::Automatic, levels), by(PatchMethod::Automatic, levels, Tying::MoveNodes),
          by(PatchMethod::MarchingCubes, levels) })
      {
        SCOPED_TRACE(std::to_string(cells) + " cells, depth " + std::to_string(levels) +
          ", method " + std::to_string(int(options.patches.method)) + ", tying " +
          std::to_string(int(options.patches.tying)));
        try
        {
          const Meshed meshed = meshOf(soup, cellsAlongLongest(soup, cells), options);
          expectWatertight(meshed.patches);
          EXPECT_TRUE(isValid(meshed.mesh));
          EXPECT_TRUE(meshed.flawedBoxes.empty());
          // What is flatter than the clearance has edges that are shorter.
          if (options.patches.method == PatchMethod::Automatic && GetParam().name != "Flat")
          {
            expectSoundFaces(meshed);
          }
        }
        catch (const Error& error)
        {
          // Marching Cubes sees nothing of what is thinner than a box.
          EXPECT_EQ(options.patches.method, PatchMethod::MarchingCubes) << error.what();
          EXPECT_EQ(error.fault, Fault::FlawedSurface) << error.what();
        }
      }
    }
  }
}

INSTANTIATE_TEST_SUITE_P(Clean, PatchesBy, ::testing::ValuesIn(cleanShapes()), nameOf);

std::ptrdiff_t boxesBecause(const Meshed& meshed, PatchReason reason)
{
  return std::count(meshed.patches.reason.begin(), meshed.patches.reason.end(), reason);
}

TEST_P(SharpShape, IsKeptAsItIs)
{
  const Soup& soup = GetParam().soup;
  for (const int levels : { 0, 1 })
  {
    const Meshed meshed =
      meshOf(soup, cellsAlongLongest(soup, 11.3), by(PatchMethod::Automatic, levels));
    EXPECT_TRUE(isValid(meshed.mesh));
    EXPECT_NEAR(volumeOf(meshed.mesh), soup.volume(), 1e-6 * soup.volume());
    EXPECT_GT(boxesBecause(meshed, PatchReason::SharpFeature), 0);
    EXPECT_GT(meshed.statistics.at("BoxesByMarchingCubes"), 0);
  }
}

INSTANTIATE_TEST_SUITE_P(Planes, SharpShape, ::testing::ValuesIn(sharpShapes()), nameOf);

TEST_P(SmoothShape, ErrorFallsWithTheSquareOfTheCellSize)
{
  const Soup& soup = GetParam().soup;
  for (const PatchMethod method : { PatchMethod::Automatic, PatchMethod::MarchingCubes })
  {
    std::vector<double> errors;
    for (const double cells : { 24.0, 48.0, 96.0 })
    {
      const Meshed meshed = meshOf(soup, cellsAlongLongest(soup, cells), by(method));
      errors.push_back(std::abs(volumeOf(meshed.mesh) - soup.volume()));
      if (cells == 96.0)
      {
        EXPECT_GT(meshed.statistics.at("BoxesByMarchingCubes"),
          0.85 * meshed.statistics.at("BoxesIntersected"));
        EXPECT_LT(meshed.statistics.at("Patches"), 3 * meshed.statistics.at("BoxesIntersected"));
      }
    }
    EXPECT_GT(errors[0] / errors[2], 9) << errors[0] << " " << errors[1] << " " << errors[2];
  }
}

INSTANTIATE_TEST_SUITE_P(Of, SmoothShape, ::testing::ValuesIn(smoothShapes()), nameOf);

// Each condition for Exact Fit, alone.
TEST(PatchChoice, NamesTheCondition)
{
  GridSpec grid;
  for (auto& lines : grid.meshlines)
  {
    lines = { -3, -2, -1, 0, 1, 2, 3 };
  }
  const auto count = [&](const Soup& soup, PatchReason reason) {
    return boxesBecause(meshOf(soup, grid, by(PatchMethod::Automatic)), reason);
  };
  // A thin plate crosses edges twice.
  const Soup plate = box({ -1.5, -1.5, 0.2 }, { 1.5, 1.5, 0.4 });
  EXPECT_EQ(count(plate, PatchReason::EdgeCrossedTwice), 16);
  // A ball of 0.3 in the middle of a side between two boxes.
  const Soup ball = sphere(8, 0.3).moved({ 0.5, 0.5, 0 });
  EXPECT_EQ(count(ball, PatchReason::ClosedPolyline), 2);
  EXPECT_EQ(count(ball, PatchReason::EdgeCrossedTwice), 0);
  // ... in the middle of a box.
  EXPECT_EQ(count(sphere(8, 0.3).moved({ 0.5, 0.5, 0.5 }), PatchReason::NotDiscs) +
      count(sphere(8, 0.3).moved({ 0.5, 0.5, 0.5 }), PatchReason::SharpFeature),
    1);
  // A cube: 12 edges through four boxes each, and eight corners.
  Soup block = box({ -2.5, -2.5, -2.5 }, { 2.5, 2.5, 2.5 });
  block.boundary.clear();
  EXPECT_EQ(count(block, PatchReason::SharpFeature), 12 * 4 + 8);
  EXPECT_EQ(count(block, PatchReason::MarchingCubes), 6 * 16);
  // The same cube, one face divided into two boundaries: they meet along the face's diagonal.
  block.boundary.assign(block.triangles.size(), 0);
  block.boundary[0] = 1;
  EXPECT_GE(count(block, PatchReason::SeveralBoundaries), 4);
  EXPECT_EQ(count(block, PatchReason::SeveralBoundaries) + count(block, PatchReason::MarchingCubes),
    6 * 16);
}

TEST(FoldedGeometry, DisappearsInMarchingCubesBoxes)
{
  const Soup soup = foldedBlock();
  GridSpec grid;
  for (auto& lines : grid.meshlines)
  {
    lines = { -3, -2, -1, 0, 1, 2, 3 };
  }
  const Meshed meshed = meshOf(soup, grid, by(PatchMethod::Automatic));
  EXPECT_TRUE(isValid(meshed.mesh));
  // In boxes that the block's edges miss, the fold is gone: one patch, upward.
  Execution execution;
  const std::vector<std::uint32_t> intersected = intersectedBoxes(meshed.boxed.boxes, execution);
  std::size_t boxes = 0;
  for (std::size_t n = 0; n < intersected.size(); ++n)
  {
    const Box b = meshed.boxed.boxes.box(intersected[n]);
    const auto& index = meshed.boxed.boxes.globalOf(b).index;
    if (index[2] == 5 && index[0] == 3 && index[1] > 0 && index[1] < 5)
    {
      ++boxes;
      EXPECT_EQ(meshed.patches.reason[n], PatchReason::MarchingCubes);
      EXPECT_EQ(meshed.patches.boxStart[n + 1] - meshed.patches.boxStart[n], 1u);
      const Vector normal = areaVector(meshed, meshed.patches.boxStart[n]);
      EXPECT_GT(normal[2], 0.999);
    }
  }
  EXPECT_EQ(boxes, 4u);
}

// Of a ball of 19,200 triangles in eight boxes, of 2,400 triangles a box about a hundred patches are left.
TEST(Simplification, LeavesFewPatches)
{
  const Soup ball = sphere(40, 1).turned();
  const Meshed meshed = meshOf(ball, cellsAlongLongest(ball, 2), by(PatchMethod::Automatic));
  EXPECT_TRUE(isValid(meshed.mesh));
  EXPECT_LT(meshed.statistics.at("Patches"), 120 * meshed.statistics.at("BoxesIntersected"));
  EXPECT_NEAR(volumeOf(meshed.mesh), ball.volume(), 0.03 * ball.volume());
}

TEST(PatchMethods, ThreadsDoNotMatter)
{
  const Soup soup = blockWithTubes().turned();
  TestOptions options = by(PatchMethod::Automatic, 2);
  const Meshed one = meshOf(soup, cellsAlongLongest(soup, 15), options);
  for (const int threads : cases({ 2, 3, 8 }))
  {
    options.threads = threads;
    EXPECT_TRUE(meshOf(soup, cellsAlongLongest(soup, 15), options).mesh == one.mesh);
  }
}
