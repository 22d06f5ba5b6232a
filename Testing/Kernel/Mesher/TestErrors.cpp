// What cannot be meshed is refused: the right fault, and words that name the place.
#include "Base/Error.h"
#include "Support/MeshChecker.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

using namespace cartesian;

namespace
{

constexpr double Nan = std::numeric_limits<double>::quiet_NaN();
constexpr double Infinity = std::numeric_limits<double>::infinity();

template <class Action>
void expectError(Fault fault, const std::vector<std::string>& words, const Action& action)
{
  try
  {
    action();
    ADD_FAILURE() << "nothing was thrown";
  }
  catch (const Error& error)
  {
    EXPECT_EQ(static_cast<int>(error.fault), static_cast<int>(fault)) << error.what();
    for (const std::string& word : words)
    {
      EXPECT_NE(std::string(error.what()).find(word), std::string::npos)
        << "no \"" << word << "\" in: " << error.what();
    }
  }
}

void expectRefusal(Fault fault, const std::vector<std::string>& words, const Soup& soup,
  const GridSpec& grid = cellsOf(0.3))
{
  expectError(fault, words, [&] { prepare(soup, grid); });
}

GridSpec meshlinesY(const std::vector<double>& lines)
{
  GridSpec grid = cellsOf(0.3);
  grid.meshlines[1] = lines;
  return grid;
}

}

TEST(Errors, EmptySurface)
{
  expectRefusal(Fault::EmptySurface, { "no triangles" }, {});
  Soup points = cube();
  points.triangles.clear();
  expectRefusal(Fault::EmptySurface, { "no triangles" }, points);
}

TEST(Errors, APointIsNoSurface)
{
  Soup soup;
  soup.points.assign(3, { 1, 2, 3 });
  soup.triangles = { { 0, 1, 2 } };
  expectRefusal(Fault::EmptySurface, { "coincide" }, soup);
}

TEST(Errors, BadCoordinates)
{
  for (const double bad : { Nan, Infinity, -Infinity, 1e200 })
  {
    Soup soup = cube();
    soup.points[5][1] = bad;
    expectRefusal(Fault::BadCoordinate, { "Point 5", "cell 2" }, soup);
  }
}

// Or volumes are zero or infinite.
TEST(Errors, SurfacesOfUnearthlySizes)
{
  expectRefusal(Fault::BadCoordinate, { "1e-150 long", "Scale it up" }, cube().scaled(1e-150));
  expectRefusal(Fault::BadCoordinate, { "too large" }, cube().scaled(1e120));
  for (const double size : { 1e-69, 1e100 })
  {
    const Meshed meshed = meshOf(cube().scaled(size), cellsOf(size / 4));
    EXPECT_TRUE(isValid(meshed.mesh));
    EXPECT_GT(volumeOf(meshed.mesh) / size / size / size, 0.999);
  }
}

TEST(Errors, BadCoordinatesOfUnusedPointsAreHarmless)
{
  Soup soup = cube();
  soup.points.push_back({ Nan, Infinity, 0 });
  EXPECT_EQ(meshOf(soup, cellsOf(0.5)).mesh.cells(), meshOf(cube(), cellsOf(0.5)).mesh.cells());
}

TEST(Errors, TrianglesThatNameNoPoint)
{
  Soup soup = cube();
  soup.triangles[3][1] = 77;
  expectRefusal(Fault::BadParameter, { "Cell 3", "point 77", "8 points" }, soup);
}

TEST(Errors, BadCellSize)
{
  for (const double bad : { -1.0, Nan, Infinity, -Infinity })
  {
    expectRefusal(Fault::BadCellSize, { "Cell Size is" }, cube(), cellsOf(bad));
  }
  expectRefusal(Fault::BadCellSize, { "Cell Size is", "only 1" }, cube(), cellsOf(1e6));
}

TEST(Errors, CellsBelowTheLattice)
{
  expectRefusal(
    Fault::TooManyBoxes, { "1e+09", "Memory Limit", "Cell Size" }, cube(), cellsOf(1e-9));
  expectRefusal(Fault::TooManyBoxes, { "Cell Size" }, cube(), cellsOf(1e-300));
  // Few cells, but of a surface so far away that coordinates cannot tell them apart.
  expectRefusal(
    Fault::BadCellSize, { "closer than the lattice" }, cube().moved({ 1e15, 0, 0 }), cellsOf(0.25));
}

TEST(Errors, ZeroIsTheDefaultCellSize)
{
  const PreparedSurface prepared = prepare(cube(), cellsOf(0));
  EXPECT_EQ(prepared.planes[0].size(), 51U);
  EXPECT_TRUE(prepared.planes.lines == prepare(cube(), cellsOf(1.0 / 50)).planes.lines);
}

TEST(Errors, BadMeshlines)
{
  expectRefusal(Fault::BadMeshlines, { "Meshlines Y", "one position" }, cube(), meshlinesY({ 0 }));
  expectRefusal(Fault::BadMeshlines, { "Meshlines Y", "position 2", "0.3", "0.5" }, cube(),
    meshlinesY({ 0, 0.5, 0.3, 1 }));
  expectRefusal(
    Fault::BadMeshlines, { "Meshlines Y", "position 1" }, cube(), meshlinesY({ 0.5, 0.5 }));
  expectRefusal(
    Fault::BadMeshlines, { "Meshlines Y", "position 1" }, cube(), meshlinesY({ 0, Nan, 1 }));
  expectRefusal(
    Fault::BadMeshlines, { "Meshlines Y", "position 0" }, cube(), meshlinesY({ -Infinity, 1 }));
  expectRefusal(
    Fault::BadMeshlines, { "Meshlines Y", "position 1" }, cube(), meshlinesY({ 0, Infinity }));
  expectRefusal(
    Fault::BadMeshlines, { "Meshlines Y", "miss the surface" }, cube(), meshlinesY({ 2, 3 }));
  expectRefusal(
    Fault::BadMeshlines, { "Meshlines Y", "miss the surface" }, cube(), meshlinesY({ -2, 0 }));
}

TEST(Errors, MeshlinesCloserThanTheLattice)
{
  expectRefusal(Fault::BadMeshlines, { "along Y", "0.5" }, cube(),
    meshlinesY({ 0, 0.5, std::nextafter(0.5, 1), 1 }));
}

// In the fine grid, their positions would not fit in 32 bits.
TEST(Errors, TooManyMeshlines)
{
  std::vector<double> lines((1 << 20) + 1);
  for (std::size_t i = 0; i < lines.size(); ++i)
  {
    lines[i] = double(i) / double(1 << 20);
  }
  expectRefusal(
    Fault::TooManyBoxes, { "Meshlines Y", "1.04858e+06", "fewer" }, cube(), meshlinesY(lines));
  expectRefusal(Fault::TooManyBoxes, { "along X", "larger" }, box({ 0, 0, 0 }, { 1, 1e-6, 1e-6 }),
    cellsOf(9e-7));
}

TEST(Errors, MemoryLimit)
{
  expectError(Fault::TooManyBoxes, { "Memory Limit", "boxes" },
    [&] { prepare(cube(), cellsOf(0.01), 1e-3); });
  EXPECT_NO_THROW(prepare(cube(), cellsOf(0.01), 10));
}

TEST(Errors, MemoryLimitOfRefinement)
{
  Execution execution;
  const PreparedSurface prepared = prepare(cube(), cellsOf(0.1), 0.1);
  EXPECT_NO_THROW(boxSurface(prepared, depth(1), execution));
  expectError(Fault::TooManyBoxes, { "Memory Limit" },
    [&] { boxSurface(prepared, depth(DeepestLevel), execution); });
}

TEST(Errors, BadDepth)
{
  for (const int bad : { -1, DeepestLevel + 1 })
  {
    expectError(Fault::BadParameter, { "Depth", std::to_string(bad) },
      [&] { meshOf(cube(), cellsOf(0.3), asTheyAre(0, depth(bad))); });
  }
}

TEST(Errors, BadSmallCellRatio)
{
  for (const double bad : { -1e-3, 1.0, 2.0, Nan, Infinity })
  {
    expectError(Fault::BadParameter, { "Small Cell Ratio" },
      [&] { meshOf(cube(), cellsOf(0.3), asTheyAre(bad)); });
  }
}

TEST(Errors, OptionsOutOfTheirRange)
{
  const auto expectRefused = [](const char* name, double value, const auto& set) {
    TestOptions options;
    set(options, value);
    expectError(Fault::BadParameter, { name }, [&] { meshOf(cube(), cellsOf(0.3), options); });
  };
  for (const double bad : { -1e-3, Nan, Infinity })
  {
    expectRefused(
      "Feature Angle", bad, [](Options& o, double value) { o.patches.featureAngle = value; });
    expectRefused(
      "Merge Angle", bad, [](Options& o, double value) { o.patches.mergeAngle = value; });
    expectRefused(
      "Collapse Ratio", bad, [](Options& o, double value) { o.collapse.ratio = value; });
    expectRefused(
      "Merge Ratio", bad, [](Options& o, double value) { o.shaping.mergeRatio = value; });
    expectRefused("boundary 3", bad, [](Options& o, double value) {
      o.smallCells.boundaryRatios.push_back({ 3, value });
    });
  }
  expectRefused(
    "Refused Cell Ratio", -1, [](Options& o, double value) { o.shaping.refusedCellRatio = value; });
}

TEST(Errors, NothingToMesh)
{
  const Soup flat = cube().scaled({ 1, 1, 0 });
  expectError(Fault::FlawedSurface, { "nothing" }, [&] { meshOf(flat, cellsOf(0.3)); });
  expectError(Fault::FlawedSurface, { "Small Cell Ratio" },
    [&] { meshOf(cube().scaled(0.01), cellsOf(0.3), asTheyAre(0.5)); });
}

TEST(Errors, StoppedAtOnce)
{
  const Soup soup = sphere(6, 1);
  TestOptions options;
  options.grid = cellsOf(0.1);
  options.patches = exactFit();
  for (int calls = 1; calls < 12; ++calls)
  {
    for (const int threads : { 1, 3 })
    {
      int called = 0;
      Execution execution(threads, [&](double, const char*) { return ++called < calls; });
      EXPECT_THROW(mesh(soup.view(), options, execution), Stopped);
      EXPECT_EQ(called, calls);
    }
  }
}
