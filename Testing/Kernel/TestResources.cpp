// Extremes of size and place: bounded time and memory, a mesh or a clear message.
#include "Effort.h"
#include "Error.h"
#include "FuzzedSurface.h"

#include <gtest/gtest.h>

#include <algorithm>
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

// Run by hand: TestKernel --gtest_also_run_disabled_tests --gtest_filter=*HundredThousand*
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
    const Vec p{ at(random), at(random), at(random) };
    soup.points.insert(
      soup.points.end(), { p, { p[0] + 0.01, p[1], p[2] + 0.003 }, { p[0], p[1] + 0.01, p[2] } });
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
