// Volume-true walls: the mesh encloses what the surface does, and flat walls and sharp edges stay.
#include "Support/Effort.h"
#include "Support/MeshChecker.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

using namespace cartesian;

namespace
{

// With the user's defaults; nodes only move off the surface where cells are shaped.
TestOptions with(bool trueVolume, int levels = 0)
{
  TestOptions options;
  options.shaping.trueVolume = trueVolume;
  options.refinement = depth(levels);
  return options;
}

// Of the mesh, by the surface's.
double volumeError(const Soup& soup, double cells, const TestOptions& options)
{
  return volumeOf(meshOf(soup, cellsAlongLongest(soup, cells), options).mesh) / soup.volume() - 1;
}

class RoundShape : public ::testing::TestWithParam<NamedShape>
{
};

class FlatShape : public ::testing::TestWithParam<NamedShape>
{
};

// With walls that bend both ways: nodes go both ways.
std::vector<NamedShape> roundShapes()
{
  return { { "Sphere", sphere(40, 1) }, { "Torus", torus(60, 1, 0.4).turned() },
    { "BumpySphere", bumpySphere(3, 40) } };
}

std::vector<NamedShape> flatShapes()
{
  return { { "Cube", cube().turned() }, { "Octahedron", octahedron(1).turned(2, 20) },
    { "BlockWithTubes", blockWithTubes().turned() } };
}

}

TEST_P(RoundShape, KeepsItsVolume)
{
  const Soup& soup = GetParam().soup;
  for (const int levels : { 0, 1 })
  {
    for (const double cells : cases({ 17.3, 30.0 }))
    {
      const double chords = volumeError(soup, cells, with(false, levels));
      const double standing = volumeError(soup, cells, with(true, levels));
      EXPECT_LT(std::abs(standing), 0.35 * std::abs(chords)) << cells << " cells, depth " << levels;
    }
  }
}

INSTANTIATE_TEST_SUITE_P(Of, RoundShape, ::testing::ValuesIn(roundShapes()), nameOf);

// Unless walls of cells that solvers refuse gave way: then it comes closer to its volume.
TEST_P(FlatShape, StaysAsItIs)
{
  constexpr double Rounding = 1e-9; // of coordinates; at most 100 times as much
  const Soup& soup = GetParam().soup;
  int same = 0;
  for (const int levels : { 0, 1 })
  {
    for (const double cells : cases({ 8.3, 11.3, 14.3 }))
    {
      const GridSpec grid = cellsAlongLongest(soup, cells);
      const MeshArrays chords = meshOf(soup, grid, with(false, levels)).mesh;
      const MeshArrays standing = meshOf(soup, grid, with(true, levels)).mesh;
      const double lost = std::abs(volumeOf(chords) / soup.volume() - 1);
      EXPECT_TRUE(chords == standing || lost > Rounding)
        << cells << " cells, depth " << levels << ": " << lost;
      EXPECT_LE(std::abs(volumeOf(standing) / soup.volume() - 1), std::max(lost, 100 * Rounding));
      same += chords == standing ? 1 : 0;
    }
  }
  EXPECT_GT(same, 0);
}

INSTANTIATE_TEST_SUITE_P(Of, FlatShape, ::testing::ValuesIn(flatShapes()), nameOf);

// On a circle, the nodes of a chord go out by less than the chord is off in its middle. All but one in a
// hundred: where a sliver is left out the wall is off in any case.
TEST(TrueVolume, ComesNearerToTheSurface)
{
  const Soup ball = sphere(60, 1).turned();
  const auto farthest = [&](bool trueVolume) {
    const MeshArrays mesh = meshOf(ball, cellsAlongLongest(ball, 20), with(trueVolume)).mesh;
    std::vector<double> distances;
    const auto add = [&](const Vector& at) { distances.push_back(std::abs(norm(at) - 1)); };
    for (std::size_t f = 0; f + 1 < mesh.boundaryStart.size(); ++f)
    {
      const auto begin = static_cast<std::size_t>(mesh.boundaryStart[f]);
      const auto end = static_cast<std::size_t>(mesh.boundaryStart[f + 1]);
      Vector mean{};
      for (std::size_t c = begin; c < end; ++c)
      {
        const double* const x = &mesh.points[3 * static_cast<std::size_t>(mesh.boundaryPoints[c])];
        mean = plus(mean, scaled({ x[0], x[1], x[2] }, 1.0 / double(end - begin)));
        add({ x[0], x[1], x[2] });
      }
      add(mean);
    }
    const auto most = distances.end() - std::ptrdiff_t(distances.size() / 100) - 1;
    std::nth_element(distances.begin(), most, distances.end());
    return *most;
  };
  EXPECT_LT(farthest(true), 0.9 * farthest(false));
}

// Where cells stay as they are cut, so do nodes; and other methods have no chords, or want them.
TEST(TrueVolume, IsNothingToOtherMeshes)
{
  const Soup ball = sphere(20, 1);
  const GridSpec grid = cellsAlongLongest(ball, 8);
  for (const PatchMethod method : { PatchMethod::ExactFit, PatchMethod::MarchingCubes })
  {
    TestOptions yes = with(true);
    TestOptions no = with(false);
    yes.patches.method = no.patches.method = method;
    EXPECT_TRUE(meshOf(ball, grid, yes).mesh == meshOf(ball, grid, no).mesh);
  }
  TestOptions yes = asTheyAre();
  yes.patches.method = PatchMethod::Automatic;
  TestOptions no = yes;
  no.shaping.trueVolume = false;
  EXPECT_TRUE(meshOf(ball, grid, yes).mesh == meshOf(ball, grid, no).mesh);
}

TEST(SurfaceVolume, IsThatOfTheDomain)
{
  const Soup ball = sphere(20, 1);
  TestOptions options = with(true);
  const auto inside = meshOf(ball, cellsAlongLongest(ball, 8), options).statistics;
  EXPECT_NEAR(inside.at("SurfaceVolume"), ball.volume(), 1e-6);
  EXPECT_NEAR(inside.at("MeshVolume"), ball.volume(), 1e-2 * ball.volume());
  options.domain.domain = Domain::Outside;
  options.domain.boxFrom = BoxSource::Bounds;
  options.domain.bounds = { { -2, -2, -2 }, { 2, 2, 2 } };
  const auto outside = meshOf(ball, cellsOf(0.25), options).statistics;
  EXPECT_NEAR(outside.at("SurfaceVolume"), 64 - ball.volume(), 1e-6);
  options.domain.bounds = { { -2, -2, -2 }, { 0.5, 2, 2 } };
  EXPECT_EQ(meshOf(ball, cellsOf(0.25), options).statistics.at("SurfaceVolume"), 0);
}
