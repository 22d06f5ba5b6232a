// Keep Points: parts of the domain without one are left out, as if the surface did not have them.
#include "Base/Error.h"
#include "Support/Effort.h"
#include "Support/MeshChecker.h"

#include <gtest/gtest.h>

namespace cartesian
{
namespace
{

using Places = std::vector<std::array<double, 3>>;

GridSpec planesFrom(double low, double high, double size)
{
  GridSpec grid;
  for (std::vector<double>& lines : grid.meshlines)
  {
    for (double x = low; x < high + size; x += size)
    {
      lines.push_back(x);
    }
  }
  return grid;
}

TestOptions inside(double low, double high, double size, const Places& points)
{
  TestOptions options = asTheyAre();
  options.grid = planesFrom(low, high, size);
  options.domain.keepPoints = points;
  return options;
}

std::unique_ptr<Assembly> assembled(const Soup& soup, const TestOptions& options)
{
  Execution execution(options.threads);
  return mesh(soup.view(), options, execution);
}

MeshArrays meshed(const Soup& soup, const TestOptions& options)
{
  Execution execution(1);
  const std::unique_ptr<Assembly> assembly = assembled(soup, options);
  return arraysOf(*assembly->mesh, assembly->boxes, execution);
}

void expectRefusal(const Soup& soup, const TestOptions& options, const std::string& words)
{
  try
  {
    meshed(soup, options);
    ADD_FAILURE() << "nothing was thrown: " << words;
  }
  catch (const Error& error)
  {
    EXPECT_EQ(error.fault, Fault::BadParameter);
    EXPECT_NE(std::string(error.what()).find(words), std::string::npos) << error.what();
  }
}

TEST(KeepPoints, TheMeshIsThatOfThePartsKeptAlone)
{
  const Soup ball = sphere(4, 0.7).turned();
  const Soup ring = torus(16, 0.7, 0.2).turned().moved({ 1.9, 0.1, 0 });
  Soup all = ball;
  all.add(ring).add(cube().moved({ 0, 0, 1 }));
  for (const bool isForSolvers : { true, false })
  {
    for (const int levels : { 0, 2 })
    {
      TestOptions options = inside(-1, 3, 0.31, { { 0.1, 0.05, -0.2 } });
      if (isForSolvers)
      {
        const TestOptions defaults;
        options.patches = defaults.patches;
        options.collapse = defaults.collapse;
        options.smallCells = defaults.smallCells;
        options.shaping = defaults.shaping;
      }
      options.refinement = depth(levels);
      TestOptions alone = options;
      alone.domain.keepPoints = {};
      const std::unique_ptr<Assembly> assembly = assembled(all, options);
      EXPECT_EQ(assembly->separate.leftOut, 2U);
      const MeshArrays kept = meshed(all, options);
      EXPECT_TRUE(kept == meshed(ball, alone));
      options.threads = 3;
      EXPECT_TRUE(kept == meshed(all, options));
    }
  }
}

// The walls of all three pass through the same boxes.
TEST(KeepPoints, PartsInCommonBoxes)
{
  Soup slabs;
  for (const double z : { 0.0, 0.25, 0.5 })
  {
    slabs.add(box({ 0, 0, z }, { 1, 1, z + 0.2 }));
  }
  const Soup middle = box({ 0, 0, 0.25 }, { 1, 1, 0.45 });
  for (const int levels : { 0, 1 })
  {
    TestOptions options = inside(-0.1, 1, 0.7, { { 0.5, 0.3, 0.35 } });
    options.refinement = depth(levels);
    const MeshArrays kept = meshed(slabs, options);
    EXPECT_TRUE(isValid(kept));
    EXPECT_TRUE(fills(kept, middle));
    options.domain.keepPoints.push_back({ 0.5, 0.3, 0.1 });
    EXPECT_NEAR(volumeOf(meshed(slabs, options)), 0.4, 1e-8);
  }
}

TEST(KeepPoints, OutsideWithoutWhatTheBoxOrABodyCutsOff)
{
  TestOptions options = asTheyAre();
  options.grid = cellsOf(0.31);
  options.domain.domain = Domain::Outside;
  options.domain.boxFrom = BoxSource::Bounds;
  options.domain.bounds = { { -1, -1, -1 }, { 2, 2, 2 } };
  const Soup wall = box({ 0.4, -3, -3 }, { 0.7, 3, 3 });
  EXPECT_NEAR(volumeOf(meshed(wall, options)), 2.7 * 9, 1e-7);
  options.domain.keepPoints = { { 0, 0.1, 0.2 } };
  EXPECT_NEAR(volumeOf(meshed(wall, options)), 1.4 * 9, 1e-7);
  const Soup hollow = nestedSpheres();
  const Vector low = hollow.low();
  const Vector high = hollow.high();
  options.grid = cellsOf(0.31 * hollow.longest());
  for (std::size_t axis = 0; axis < 3; ++axis)
  {
    options.domain.bounds.low[axis] = low[axis] - 1;
    options.domain.bounds.high[axis] = high[axis] + 1;
  }
  options.domain.keepPoints = {};
  const double both = volumeOf(meshed(hollow, options));
  options.domain.keepPoints = { { low[0] - 0.5, low[1] - 0.5, low[2] - 0.5 } };
  const double outer = volumeOf(meshed(hollow, options));
  options.domain.keepPoints = { { (low[0] + high[0]) / 2, (low[1] + high[1]) / 2,
    (low[2] + high[2]) / 2 } };
  const double cavity = volumeOf(meshed(hollow, options));
  EXPECT_NEAR(outer + cavity, both, 1e-9);
  EXPECT_GT(cavity, 0);
  const Vector size = plus(minus(high, low), { 2, 2, 2 });
  EXPECT_NEAR(both + hollow.volume(), size[0] * size[1] * size[2], 1e-6);
}

// A room with a table in it, which is one body in another, and a box in the table's wood.
TEST(KeepPoints, AroundPointsOnAnySideOfTheSurface)
{
  const Soup room = box({ 0, 0, 0 }, { 4, 3, 2 });
  const Soup table = box({ 1, 1, 0.5 }, { 3, 2, 1.5 });
  const Soup drawer = box({ 1.5, 1.2, 0.8 }, { 2.5, 1.8, 1.2 });
  Soup all = room;
  all.add(table.flipped()).add(drawer);
  TestOptions options = asTheyAre();
  options.grid = cellsOf(0.37);
  options.domain.domain = Domain::AroundPoints;
  const auto volumeAround = [&](const Places& points) {
    options.domain.keepPoints = points;
    const MeshArrays mesh = meshed(all, options);
    EXPECT_TRUE(isValid(mesh));
    return volumeOf(mesh);
  };
  EXPECT_NEAR(volumeAround({ { 0.2, 0.3, 0.4 } }), 24 - 2, 1e-7);
  EXPECT_NEAR(volumeAround({ { 1.2, 1.1, 0.6 } }), 2 - 0.24, 1e-7);
  EXPECT_NEAR(volumeAround({ { 2, 1.5, 1 } }), 0.24, 1e-7);
  EXPECT_NEAR(volumeAround({ { 2, 1.5, 1 }, { 0.2, 0.3, 0.4 } }), 22.24, 1e-7);
  options.domain.keepPoints = { { 2, 1.5, 1 }, { 1.2, 1.1, 0.6 } };
  expectRefusal(all, options, "one mesh has cells on one side");
  options.domain.keepPoints = {};
  expectRefusal(all, options, "there are no Keep Points");
}

TEST(KeepPoints, PointsThatAreInNoPartAreRefused)
{
  const Soup body = cube();
  expectRefusal(body, inside(-1, 2, 0.31, { { 0.5, 0.5, 0.5 }, { 1.5, 0.5, 0.5 } }),
    "Row 1 of Keep Points, (1.5, 0.5, 0.5), lies outside the space that Domain Inside meshes");
  expectRefusal(body, inside(-1, 2, 0.31, { { 0.5, 1, 0.25 } }), "lies on the surface");
  expectRefusal(body, inside(-1, 2, 0.31, { { 1, 1, 1 } }), "lies on the surface");
  expectRefusal(body, inside(-1, 2, 0.31, { { 7, 0, 0 } }), "lies outside the grid");
  TestOptions around = inside(-1, 2, 0.31, { { -0.5, 0.5, 0.5 } });
  around.domain.domain = Domain::AroundPoints;
  expectRefusal(body, around, "lies in open space");
  const Soup two = Soup(cube()).addRegion(cube().moved({ 1, 0, 0 }));
  expectRefusal(two, inside(-1, 3, 0.31, { { 0.5, 0.5, 0.5 } }), "with one region only");
  // A step of the lattice further in is inside.
  const double next = 0x1p-30;
  EXPECT_NEAR(
    volumeOf(meshed(body, inside(-1, 2, 0.31, { { 0.5, 1 - 4 * next, 0.25 } }))), 1, 1e-8);
}

}
}
