// Surfaces with flaws: what can be meshed is meshed, validly; the rest is said.
#include "Base/Error.h"
#include "Lattice/Vector.h"
#include "Support/Effort.h"
#include "Support/MeshChecker.h"

#include <gtest/gtest.h>

#include <cmath>

using namespace cartesian;

namespace
{

constexpr double FineCells = 11.3; // along the longest dimension

Soup without(Soup soup, std::size_t begin, std::size_t end)
{
  soup.triangles.erase(soup.triangles.begin() + static_cast<std::ptrdiff_t>(begin),
    soup.triangles.begin() + static_cast<std::ptrdiff_t>(end));
  soup.boundary.clear();
  return soup;
}

Soup unmarked(Soup soup)
{
  soup.boundary.clear();
  return soup;
}

// One triangle in a hundred, at random: missing, turned over, there twice, as the bits 0 to 2 of `flaws`
// say.
Soup damaged(Soup soup, unsigned flaws, unsigned seed)
{
  std::mt19937 random(seed);
  for (std::size_t n = soup.triangles.size() / 100; n > 0; --n)
  {
    if ((flaws & 1) != 0)
    {
      std::swap(soup.triangles[random() % soup.triangles.size()], soup.triangles.back());
      soup.triangles.pop_back();
    }
    if ((flaws & 2) != 0)
    {
      auto& triangle = soup.triangles[random() % soup.triangles.size()];
      std::swap(triangle[0], triangle[1]);
    }
    if ((flaws & 4) != 0)
    {
      soup.triangles.push_back(
        std::array<std::uint32_t, 3>(soup.triangles[random() % soup.triangles.size()]));
    }
  }
  return soup;
}

void expectValidOrRefused(
  const Soup& soup, const GridSpec& grid, const TestOptions& options = asTheyAre())
{
  try
  {
    EXPECT_TRUE(isValid(meshOf(soup, grid, options).mesh));
  }
  catch (const Error& error)
  {
    EXPECT_EQ(error.fault, Fault::FlawedSurface) << error.what();
  }
}

// Valid at all sizes of cells; returns that of a good many.
Meshed meshAll(const Soup& soup)
{
  for (const double cells : { 0.2, 1.3, 4.1 })
  {
    for (const int levels : { 0, 1 })
    {
      SCOPED_TRACE(std::to_string(cells) + " cells, depth " + std::to_string(levels));
      expectValidOrRefused(soup, cellsAlongLongest(soup, cells), asTheyAre(0, depth(levels)));
    }
  }
  Meshed meshed = meshOf(soup, cellsAlongLongest(soup, FineCells));
  EXPECT_TRUE(isValid(meshed.mesh));
  EXPECT_EQ(meshed.statistics.at("BoxesFlawed"), static_cast<double>(meshed.flawedBoxes.size()));
  return meshed;
}

}

// Narrower than a box, it is put back.
TEST(Flaws, AMissingTriangle)
{
  const Soup soup = unmarked(sphere(8, 1));
  const Meshed meshed = meshAll(without(soup, 100, 101));
  EXPECT_TRUE(meshed.flawedBoxes.empty());
  EXPECT_TRUE(fills(meshed.mesh, soup));
}

TEST(Flaws, TrianglesMissingInManyPlaces)
{
  for (unsigned seed = 0; seed < repeats(3); ++seed)
  {
    Soup soup = unmarked(bumpySphere(seed, 6));
    std::mt19937 random(seed);
    for (int i = 0; i < 20; ++i)
    {
      const std::size_t t = random() % soup.triangles.size();
      soup = without(soup, t, t + 1);
    }
    meshAll(soup);
  }
}

// One triangle in a hundred is missing, turned over, there twice, or all of that: the volume is that of
// the closed surface, to one part in a hundred.
TEST(Flaws, OneTriangleInAHundred)
{
  const std::array<std::pair<const char*, Soup>, 4> shapes{ { { "sphere", unmarked(sphere(20, 1)) },
    { "torus", unmarked(torus(40, 1, 0.3)) }, { "bumpy sphere", unmarked(bumpySphere(3, 16)) },
    { "star", unmarked(starPolyhedron(5, 12)) } } };
  for (const auto& [name, soup] : shapes)
  {
    ASSERT_GT(soup.triangles.size(), 1000U) << name;
    const GridSpec grid = cellsAlongLongest(soup, 25);
    TestOptions options = asTheyAre();
    options.patches.method = PatchMethod::Automatic;
    const double volume = volumeOf(meshOf(soup, grid, options).mesh);
    for (const unsigned flaws : cases({ 1U, 2U, 3U, 4U, 5U, 6U, 7U }))
    {
      SCOPED_TRACE(name + std::string(", flaws ") + std::to_string(flaws));
      const Meshed meshed = meshOf(damaged(soup, flaws, flaws), grid, options);
      EXPECT_TRUE(isValid(meshed.mesh));
      EXPECT_NEAR(volumeOf(meshed.mesh) / volume, 1, 0.01);
    }
  }
}

TEST(Flaws, AFlippedTriangle)
{
  Soup soup = unmarked(sphere(8, 1));
  std::swap(soup.triangles[100][0], soup.triangles[100][1]);
  const Meshed meshed = meshAll(soup);
  EXPECT_TRUE(meshed.flawedBoxes.empty());
  EXPECT_TRUE(fills(meshed.mesh, unmarked(sphere(8, 1))));
}

TEST(Flaws, ADoubleTriangle)
{
  Soup soup = unmarked(sphere(8, 1));
  soup.triangles.push_back(soup.triangles[100]);
  const Meshed meshed = meshAll(soup);
  EXPECT_GT(volumeOf(meshed.mesh), 0.8 * soup.volume());
}

// One body in the file twice: there is no saying what is inside.
TEST(Flaws, EverythingTwice)
{
  const Soup soup = unmarked(sphere(4, 1));
  Soup twice = soup;
  twice.add(soup);
  GridSpec halves = cellsOf(9);
  halves.meshlines[2] = { -9, 0.1, 9 };
  expectValidOrRefused(twice, halves);
  for (const double cells : { 1.0, 5.0 })
  {
    expectValidOrRefused(twice, cellsAlongLongest(twice, cells));
  }
}

TEST(Flaws, SpheresThatOverlap)
{
  meshAll(sphere(5, 1).add(sphere(6, 0.8).moved({ 0.9, 0.1, 0.2 })));
}

TEST(Flaws, ABoxThroughABox)
{
  meshAll(cube().add(box({ 0.25, 0.25, -1 }, { 0.75, 0.75, 2 })));
  meshAll(cube().add(cube().moved({ 0.5, 0, 0 })));    // walls in one plane
  meshAll(cube().add(cube().moved({ 1, 0, 0 })));      // a wall in common
  meshAll(cube().add(cube().moved({ 1, 0.5, 0.25 }))); // part of a wall in common
}

// Bodies that cross are one: the volume is that of their union.
TEST(Flaws, BodiesThatCross)
{
  const Soup ball = unmarked(sphere(12, 1));
  // The lens between two balls of radius 1 whose middles are 1 apart.
  const double lens = 5 * Pi / 12;
  for (const PatchMethod method :
    cases({ PatchMethod::MarchingCubes, PatchMethod::ExactFit, PatchMethod::Automatic }))
  {
    SCOPED_TRACE(static_cast<int>(method));
    TestOptions options = asTheyAre();
    options.patches.method = method;
    const auto expectVolume = [&](const Soup& soup, double volume, double cells) {
      const Meshed meshed = meshOf(soup, cellsAlongLongest(soup, cells), options);
      EXPECT_TRUE(isValid(meshed.mesh));
      EXPECT_TRUE(meshed.flawedBoxes.empty());
      EXPECT_EQ(meshed.statistics.at("BoxesRebuilt"), 0);
      EXPECT_NEAR(volumeOf(meshed.mesh) / volume, 1, 0.02);
      if (method == PatchMethod::ExactFit)
      {
        EXPECT_NEAR(volumeOf(meshed.mesh) / volumeOf(meshed.prepared.surface), 1, 1e-9);
      }
    };
    Soup two = ball;
    expectVolume(two.add(ball.moved({ 0.6, 0.64, 0.48 })), 8 * Pi / 3 - lens, 30);
    Soup rods = unmarked(box({ -0.2, -0.21, -1 }, { 0.2, 0.21, 1 })).turned();
    rods.add(unmarked(box({ -1, -0.2, -0.21 }, { 1, 0.2, 0.21 })).turned());
    expectVolume(rods, 0.4 * 0.42 * 4 - 0.4 * 0.4 * 0.42, 40);
  }
}

TEST(Flaws, HalfASphere)
{
  const Soup soup = unmarked(sphere(8, 1));
  meshAll(without(soup, 0, soup.triangles.size() / 2));
  meshAll(without(soup, 0, soup.triangles.size() / 6));
}

TEST(Flaws, ASingleTriangle)
{
  const Soup soup = without(cube().turned(), 1, 12);
  for (const double cells : { 0.5, 2.0, 9.0 })
  {
    expectValidOrRefused(soup, cellsAlongLongest(soup, cells));
  }
}

TEST(Flaws, ABoxWithoutALid)
{
  const Soup open = without(cube(), 10, 12);
  const Meshed meshed = meshAll(open);
  EXPECT_FALSE(meshed.prepared.repair.check.closed());
  meshAll(without(cube(), 8, 12)); // nor a floor
}

TEST(Flaws, AMoebiusBand)
{
  Soup soup;
  const int n = 24;
  for (int i = 0; i < n; ++i)
  {
    const double u = 2 * Pi * i / n;
    for (const double v : { -0.4, 0.4 })
    {
      const double r = 1 + v * std::cos(u / 2);
      soup.points.push_back({ r * std::cos(u), r * std::sin(u), v * std::sin(u / 2) });
    }
  }
  for (std::uint32_t i = 0; i < n; ++i)
  {
    const bool last = i + 1 == n;
    const std::uint32_t a = 2 * i;
    const std::uint32_t c = last ? 1 : a + 2;
    const std::uint32_t d = last ? 0 : a + 3;
    soup.triangles.push_back({ a, a + 1, c });
    soup.triangles.push_back({ c, a + 1, d });
  }
  for (const double cells : { 1.0, 6.0 })
  {
    expectValidOrRefused(soup, cellsAlongLongest(soup, cells));
  }
}

TEST(Flaws, AreDescribedWithPlaces)
{
  Soup soup = without(cube(), 0, 1);
  const PreparedSurface prepared = prepare(soup, cellsOf(0.3));
  std::vector<Id> cells;
  for (Id i = 0; i < 11; ++i)
  {
    cells.push_back(1000 + i);
  }
  const std::string text = describeFlaws(prepared, cells, {});
  EXPECT_NE(text.find("3 open edges"), std::string::npos) << text;
  EXPECT_NE(text.find("(0, 0, 0)"), std::string::npos) << text;
  EXPECT_NE(text.find("of cell 10"), std::string::npos) << text;
  EXPECT_EQ(describeFlaws(prepare(cube(), cellsOf(0.3)), cells, {}), "");
}

// A sheet with two sides, each a boundary, as cars have them, outside of what is meshed; or left out.
TEST(Flaws, BoundariesOfWhichNothingIsLeftAreNamed)
{
  Soup soup = cube();
  for (const std::int32_t boundary : { 7, 8 })
  {
    Soup side;
    side.points = { { 2, 0, 0 }, { 3, 0, 0 }, { 3, 1, 0 }, { 2, 1, 0 } };
    side.triangles = { { 0, 1, 2 }, { 0, 2, 3 } };
    side.boundary = { boundary, boundary };
    soup.add(boundary == 7 ? side : side.flipped());
  }
  const std::vector<Id> cells(soup.triangles.size());
  const std::map<std::int32_t, std::string> names{ { 7, "fairing" }, { 5, "cube" } };
  EXPECT_EQ(describeFlaws(prepare(soup, cellsOf(0.3)), cells, names),
    "2 boundaries have no faces in the mesh (inside other bodies, on their walls, or outside the "
    "meshed space): fairing, 8. Correct the surface if faces are expected there.");
  Execution execution;
  Options options;
  options.grid = cellsOf(0.3);
  options.sheets = SheetHandling::LeaveOut;
  const std::string text =
    describeFlaws(prepareSurface(soup.view(), options, execution), cells, names);
  EXPECT_NE(text.find("2 boundaries have no faces in the mesh (all triangles"), std::string::npos)
    << text;
  EXPECT_NE(text.find(": fairing, 8."), std::string::npos) << text;

  // Written twice, a body stays.
  const Soup twice = cube().add(cube());
  const std::string ofBody =
    describeFlaws(prepare(twice, cellsOf(0.3)), std::vector<Id>(twice.triangles.size()), {});
  EXPECT_EQ(ofBody.rfind("12 duplicate triangles are left out, such as cell 0 at (", 0), 0U)
    << ofBody;
}

TEST(Flaws, MeshlinesThatCutAreMentioned)
{
  GridSpec grid;
  grid.meshlines[1] = { -1, 0.5 };
  const std::string text = describeOverhang(prepare(cube(), grid));
  EXPECT_NE(text.find("Meshlines Y"), std::string::npos) << text;
}

TEST(Flaws, BoxesMadeAnewAreDescribedWithPlaces)
{
  const PreparedSurface prepared =
    prepare(kleinBottle(20), cellsAlongLongest(kleinBottle(20), 12)); // it has no inside to unite
  Execution execution;
  TestOptions options;
  options.patches = exactFit();
  const auto decomposition = decompose(prepared, options, execution);
  const auto assembly =
    meshPart(prepared, *decomposition, decomposition->allLayers(), options, execution);
  const std::string text = describeFlaws(*assembly);
  EXPECT_TRUE(flawedBoxes(*assembly).empty()) << text;
  EXPECT_NE(text.find(std::to_string(rebuiltBoxes(*assembly).size()) + " boxes"), std::string::npos)
    << text;
  EXPECT_NE(text.find("global box "), std::string::npos) << text;
}
