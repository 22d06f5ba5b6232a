// Extremes of size and place: bounded time and memory, a mesh or a clear message.
#include "Base/Error.h"
#include "Boxes/MeshEstimate.h"
#include "Lattice/Vector.h"
#include "Support/DataFile.h"
#include "Support/Effort.h"
#include "Support/FuzzedSurface.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <fstream>
#include <iterator>

using namespace cartesian;

namespace
{

Soup unmarked(Soup soup)
{
  soup.boundary.clear();
  return soup;
}

// Surfaces made of random bytes: no crash, no invalid cell.
void expectValidMeshes(unsigned firstSeed, unsigned count)
{
  for (unsigned seed = firstSeed; seed < firstSeed + count; ++seed)
  {
    std::mt19937 random(seed);
    std::vector<std::uint8_t> bytes(24 + random() % 200);
    std::generate(bytes.begin(), bytes.end(), [&] { return static_cast<std::uint8_t>(random()); });
    EXPECT_TRUE(meshesFromBytes(bytes.data(), bytes.size())) << "seed " << seed;
  }
}

}

TEST(Fuzz, RandomBytes)
{
  expectValidMeshes(0, repeats(300));
}

// On few levels the point of a cut fell on a node of a cell that only touches there (the first two), and a node that moves
// on another (the last).
TEST(Fuzz, NoTwoNodesAtOnePlace)
{
  for (const unsigned seed : { 44546U, 200069U, 202414U })
  {
    expectValidMeshes(seed, 1);
  }
}

// For .ci/full.
TEST(Fuzz, DISABLED_AHundredThousandRandomBytes)
{
  expectValidMeshes(1000, 100000);
}

TEST(Resources, OneBoxHoldsAllTriangles)
{
  const Soup soup = unmarked(sphere(40, 1));
  const Meshed meshed = meshOf(soup, cellsAlongLongest(soup, 0.5));
  EXPECT_TRUE(fills(meshed.mesh, soup));
  EXPECT_EQ(meshed.mesh.cells(), 1U);
}

// Two cones on one rim: at their tips meet more triangles than can be looked at in pairs.
TEST(Resources, ANodeOfManyTriangles)
{
  const std::uint32_t count = 20000;
  const double angle = 2 * Pi / count;
  Soup soup;
  for (std::uint32_t i = 0; i < count; ++i)
  {
    soup.points.push_back({ std::cos(angle * i), std::sin(angle * i), 0 });
    const std::uint32_t next = (i + 1) % count;
    soup.triangles.push_back({ i, next, count });
    soup.triangles.push_back({ next, i, count + 1 });
  }
  soup.points.push_back({ 0, 0, 0.5 });
  soup.points.push_back({ 0, 0, -0.5 });
  const Meshed meshed = meshOf(soup, cellsAlongLongest(soup, 0.8), TestOptions());
  EXPECT_TRUE(isValid(meshed.mesh, true));
  EXPECT_NEAR(
    volumeOf(meshed.mesh) / soup.volume(), 1, 0.25); // of a few boxes' worth of its triangles
}

// A ring of triangular section, of too many faces to be cut.
TEST(Resources, ARingInOneBox)
{
  const std::uint32_t count = 1000;
  const double angle = 2 * Pi / count;
  Soup soup;
  for (std::uint32_t i = 0; i < count; ++i)
  {
    for (const double corner : { 0.1, 2.2, 4.3 })
    {
      const double radius = 1 + 0.2 * std::cos(corner);
      soup.points.push_back(
        { radius * std::cos(angle * i), radius * std::sin(angle * i), 0.2 * std::sin(corner) });
    }
    for (std::uint32_t k = 0; k < 3; ++k)
    {
      const std::uint32_t next = (i + 1) % count;
      const std::uint32_t a = 3 * i + k;
      const std::uint32_t b = 3 * i + (k + 1) % 3;
      soup.triangles.push_back({ a, 3 * next + k, b });
      soup.triangles.push_back({ b, 3 * next + k, 3 * next + (k + 1) % 3 });
    }
  }
  const Meshed meshed = meshOf(soup, cellsAlongLongest(soup, 0.9), TestOptions());
  EXPECT_TRUE(isValid(meshed.mesh, true));
  EXPECT_NEAR(volumeOf(meshed.mesh) / soup.volume(), 1, 0.3);
}

TEST(Resources, FewFacesOfManyCorners)
{
  Soup soup = unmarked(box({ 0, 0, 0 }, { 2, 1, 0.125 }));
  GridSpec grid = cellsOf(2);
  grid.meshlines[0] = { -0.5, 0, 0.0931647, 0.130392, 0.421673, 0.658466, 0.85534, 1.29209 };
  for (std::size_t t = 0; t < soup.triangles.size(); ++t)
  {
    Soup open = soup;
    open.triangles.erase(open.triangles.begin() + static_cast<std::ptrdiff_t>(t));
    EXPECT_TRUE(isValid(meshOf(open, grid, TestOptions()).mesh, true)) << t;
  }
}

TEST(Resources, AComponentOfOneTriangle)
{
  Soup loose;
  loose.points = { { 0.2, 0.2, 0.2 }, { 0.8, 0.3, 0.4 }, { 0.5, 0.9, 0.6 } };
  loose.triangles = { { 0, 1, 2 } };
  const Soup soup = unmarked(unmarked(cube()).add(loose));
  for (const double size : { 0.1, 0.3, 2.0 })
  {
    const Meshed meshed = meshOf(soup, cellsOf(size));
    EXPECT_EQ(meshed.prepared.repair.loose.size(), 1U);
    EXPECT_TRUE(meshed.prepared.repair.holes.empty());
    EXPECT_EQ(meshed.statistics.at("BoxesRebuilt"), 0) << size;
    EXPECT_NEAR(volumeOf(meshed.mesh), 1, 1e-6) << size;
  }
}

TEST(Resources, ThousandsOfLooseTriangles)
{
  std::mt19937 random(1);
  std::uniform_real_distribution<double> at(0, 1);
  Soup soup;
  for (std::uint32_t t = 0; t < 20000; ++t)
  {
    const auto any = [&] { return Vector{ at(random), at(random), at(random) }; };
    // Each in a cell of its own, further from others than cracks are wide (Cracks.h).
    constexpr std::uint32_t Side = 28;
    const Vector cell{ double(t % Side), double(t / Side % Side), double(t / Side / Side) };
    const Vector p = scaled(plus(cell, scaled(any(), 0.5)), 1. / Side);
    soup.points.insert(
      soup.points.end(), { p, plus(p, scaled(any(), 0.01)), plus(p, scaled(any(), 0.01)) });
    soup.triangles.push_back({ 3 * t, 3 * t + 1, 3 * t + 2 });
  }
  const PreparedSurface prepared = prepare(soup, cellsOf(0.05));
  EXPECT_EQ(prepared.repair.loose.size(), 20000U);
  EXPECT_TRUE(prepared.repair.holes.empty());
  try
  {
    meshPrepared(prepared);
    FAIL() << "nothing is enclosed";
  }
  catch (const Error& error)
  {
    EXPECT_EQ(error.fault, Fault::FlawedSurface) << error.what();
  }
}

// Few boxes, but 70,000 patches in them: the estimate that boxes allow is too low, and the limit holds.
TEST(Resources, MemoryLimitHoldsForDetailInBoxes)
{
  constexpr double Taken = 35e6 / 1024 / 1024 / 1024; // GiB, measured
  const Soup soup = sphere(60, 1);
  Options options;
  options.grid = cellsAlongLongest(soup, 12);
  options.patches = exactFit();
  options.memoryLimit = Taken;
  Execution execution(2);
  try
  {
    mesh(soup.view(), options, execution);
    FAIL() << "more memory than the limit";
  }
  catch (const Error& error)
  {
    EXPECT_EQ(error.fault, Fault::TooManyBoxes) << error.what();
  }
}

// Against what "Benchmark memory" measured.
TEST(Resources, MemoryIsEstimated)
{
  struct Case
  {
    const char* file;
    double cells;
    int depth;
    PatchMethod method;
    double taken; // MB
  };
  const Case cases[] = { { "kcl_exhaust_header_lumens.stl", 30, 0, PatchMethod::Automatic, 27.6 },
    { "kcl_exhaust_header_lumens.stl", 30, 2, PatchMethod::Automatic, 156.0 },
    { "kcl_exhaust_header_lumens.stl", 30, 2, PatchMethod::ExactFit, 204.4 },
    { "tm_featuretype_occ.stl", 30, 0, PatchMethod::Automatic, 20.0 },
    { "tm_featuretype_occ.stl", 30, 2, PatchMethod::Automatic, 120.3 },
    { "tm_featuretype_occ.stl", 30, 2, PatchMethod::ExactFit, 167.9 } };
  for (const Case& c : cases)
  {
    const Soup soup = readData(c.file).soup;
    Options options;
    options.grid = cellsAlongLongest(soup, c.cells);
    options.refinement.depth = c.depth;
    options.patches.method = c.method;
    Execution execution;
    const PreparedSurface prepared = prepareSurface(soup.view(), options, execution);
    const auto decomposition = decompose(prepared, options, execution);
    const SlabRange all = decomposition->allLayers();
    const Boxes boxes = decomposition->boxes(all, execution);
    const double estimated =
      decomposition->together(estimateLayers(decomposition->shoeboxes(), boxes, execution), all)
        .bytes(prepared.memoryLimit);
    EXPECT_GT(estimated, 1e6 * c.taken) << c.file << ", depth " << c.depth;
    EXPECT_LT(estimated, 2e6 * c.taken) << c.file << ", depth " << c.depth;
  }
}

TEST(Resources, CoordinatesOfAnySize)
{
  for (const double size : { 1e-30, 1e-6, 1e30, 1e100 })
  {
    const Soup soup = unmarked(cube().scaled(size));
    const Meshed meshed = meshOf(soup, cellsAlongLongest(soup, 3.3));
    EXPECT_NEAR(volumeOf(meshed.mesh) / soup.volume(), 1, 1e-9) << size;
  }
  Soup soup = cube();
  soup.points[3] = { 1e200, 0, 0 };
  try
  {
    meshOf(soup, cellsOf(0.1));
    FAIL() << "1e200 squared is no number";
  }
  catch (const Error& error)
  {
    EXPECT_EQ(error.fault, Fault::BadCoordinate) << error.what();
  }
}

// What the fuzzer covers most with, on other compilers than clang too.
TEST(Fuzz, CorpusGivesValidMeshes)
{
  std::size_t files = 0;
  for (const auto& file : std::filesystem::directory_iterator(CORPUS_FOLDER))
  {
    std::ifstream stream(file.path(), std::ios::binary);
    const std::string bytes(std::istreambuf_iterator<char>(stream), {});
    EXPECT_TRUE(meshesFromBytes(reinterpret_cast<const std::uint8_t*>(bytes.data()), bytes.size()))
      << file.path();
    ++files;
  }
  EXPECT_GE(files, 40U);
}
