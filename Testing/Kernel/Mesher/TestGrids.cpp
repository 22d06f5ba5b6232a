// Meshlines of all kinds: uneven, on walls, across the surface, far fewer than triangles.
#include "Base/Error.h"
#include "Support/MeshChecker.h"

#include <gtest/gtest.h>

#include <cmath>

using namespace cartesian;

namespace
{

GridSpec meshlines(
  const std::vector<double>& x, const std::vector<double>& y, const std::vector<double>& z)
{
  GridSpec grid;
  grid.meshlines = { x, y, z };
  return grid;
}

Meshed expectGood(const Soup& soup, const GridSpec& grid, const TestOptions& options = asTheyAre())
{
  Meshed meshed = meshOf(soup, grid, options);
  EXPECT_TRUE(isValid(meshed.mesh));
  EXPECT_TRUE(fills(meshed.mesh, soup));
  EXPECT_TRUE(meshed.flawedBoxes.empty());
  return meshed;
}

double boundaryArea(const MeshArrays& mesh, std::int32_t index)
{
  double sum = 0;
  for (std::size_t f = 0; f < mesh.boundaryCell.size(); ++f)
  {
    if (mesh.boundaryIndex[f] == index)
    {
      Soup face;
      for (Id i = mesh.boundaryStart[f]; i < mesh.boundaryStart[f + 1]; ++i)
      {
        const double* p = mesh.points.data() + 3 * mesh.boundaryPoints[static_cast<std::size_t>(i)];
        face.points.push_back({ p[0], p[1], p[2] });
      }
      Vector normal{};
      for (std::uint32_t i = 1; i + 1 < face.points.size(); ++i)
      {
        for (int axis = 0; axis < 3; ++axis)
        {
          const int u = (axis + 1) % 3;
          const int v = (axis + 2) % 3;
          const auto part = [&](std::uint32_t corner, int a) {
            return face.points[corner][a] - face.points[0][a];
          };
          normal[axis] += part(i, u) * part(i + 1, v) - part(i, v) * part(i + 1, u);
        }
      }
      sum += std::hypot(normal[0], normal[1], normal[2]) / 2;
    }
  }
  return sum;
}

}

TEST(Grids, UnevenMeshlines)
{
  const std::vector<double> lines = { -3, -0.9, -0.899, -0.2, 0.00001, 0.3, 0.31, 0.7, 50 };
  for (const Soup& soup : { bumpySphere(1, 7), torus(10, 0.9, 0.4), cube().turned() })
  {
    expectGood(soup, meshlines(lines, lines, lines));
    expectGood(soup, meshlines(lines, {}, { -100, 0, 100 }));
  }
}

// Walls of the surface on meshlines, at the ends of the grid and within it.
TEST(Grids, MeshlinesOnWalls)
{
  const std::vector<double> lines = { 0, 0.25, 0.5, 0.75, 1 };
  const std::vector<double> wider = { -1, 0, 0.25, 0.5, 0.75, 1, 2 };
  const Soup l = voxels({ lines, lines, lines }, [](int i, int j, int) { return i < 2 || j < 1; });
  const Soup checkers =
    voxels({ lines, lines, lines }, [](int i, int j, int k) { return (i + j + k) % 2 == 0; });
  const Soup cavity = voxels({ lines, lines, lines },
    [](int i, int j, int k) { return i % 3 == 0 || j % 3 == 0 || k % 3 == 0; });
  for (const Soup& soup : { cube(), l, cavity, checkers })
  {
    expectGood(soup, meshlines(lines, lines, lines));
    expectGood(soup, meshlines(wider, wider, wider));
    expectGood(soup, meshlines(wider, wider, wider), asTheyAre(0, depth(1)));
  }
}

// The cube on its own meshlines loses nothing when slivers are removed: it is the boxes themselves.
TEST(Grids, ACubeOnItsOwnMeshlinesIsAllHexahedra)
{
  const std::vector<double> lines = { -1, 0, 0.25, 0.5, 0.75, 1, 2 };
  const Meshed meshed = meshOf(cube(), meshlines(lines, lines, lines), asTheyAre(1e-3));
  EXPECT_TRUE(isValid(meshed.mesh));
  EXPECT_TRUE(fills(meshed.mesh, cube()));
  EXPECT_EQ(meshed.mesh.cells(), 64U);
}

// Edges along box edges and along diagonals of boxes.
TEST(Grids, EdgesAlongBoxEdgesAndDiagonals)
{
  const std::vector<double> lines = { -2, -1, -0.5, 0, 0.5, 1, 2 };
  const Soup diamond = box({ -0.5, -0.5, -0.5 }, { 0.5, 0.5, 0.5 }).each([](const Vector& p) {
    return Vector{ p[0] - p[1], p[0] + p[1], p[2] };
  });
  const Soup sheared = box({ -0.5, -0.5, -0.5 }, { 0.5, 0.5, 0.5 }).each([](const Vector& p) {
    return Vector{ p[0] + p[1], p[1] + p[2], p[2] };
  });
  for (const Soup& soup : { octahedron(1), octahedron(0.5), diamond, sheared,
         tetrahedron({ { { -1, -1, -1 }, { 1, 1, -1 }, { 1, -1, 1 }, { -1, 1, 1 } } }) })
  {
    expectGood(soup, meshlines(lines, lines, lines));
    expectGood(soup, cellsOf(0.25));
    expectGood(soup, cellsOf(0.5), asTheyAre(0, depth(2)));
  }
}

TEST(Grids, TwoThousandTrianglesInOneBox)
{
  const Soup soup = bumpySphere(3, 13);
  EXPECT_GT(soup.triangles.size(), 2000U);
  const Meshed meshed = expectGood(soup, cellsOf(10 * soup.longest()));
  EXPECT_EQ(meshed.mesh.cells(), 1U);
  expectGood(soup.moved({ 0.01, 0.02, 0.03 }), meshlines({ -9, 0, 9 }, { -9, 9 }, { -9, 9 }));
}

TEST(Grids, TrianglesAThousandBoxesLong)
{
  std::vector<double> lines;
  for (int i = -1; i <= 1001; ++i)
  {
    lines.push_back(i);
  }
  const Soup soup =
    tetrahedron({ { { 0, 0, 0 }, { 1000, 0.3, 0.7 }, { 400, 3, 0.2 }, { 500, 1, 3.1 } } });
  expectGood(soup, meshlines(lines, { -1, 0.4, 1.3, 4 }, { -1, 1, 4 }));
}

// Nine cavities cut by a meshline, then 64 turned at random: bridges between holes must not cross.
TEST(Grids, ASideWithManyHoles)
{
  Soup nine = cube();
  for (int i = 0; i < 9; ++i)
  {
    const double x = 0.1 + 0.3 * (i % 3) + 0.001 * i;
    const double y = 0.1 + 0.3 * (i / 3) + 0.002 * i;
    nine.add(box({ x, y, 0.3 }, { x + 0.15, y + 0.15, 0.7 }).flipped());
  }
  Soup many = cube();
  for (int i = 0; i < 64; ++i)
  {
    const Soup cavity = box({ -0.03, -0.03, -0.2 }, { 0.03, 0.03, 0.2 }).turned(2, 37 * i);
    many.add(cavity.moved({ 0.1 + 0.11 * (i % 8), 0.1 + 0.11 * (i / 8), 0.5 }).flipped());
  }
  for (const Soup& soup : { nine, many, nine.turned(), many.turned(), blockWithTubes() })
  {
    expectGood(soup, meshlines({ -5, 5 }, { -5, 5 }, { -5, 0.5, 5 }));
    expectGood(soup, meshlines({ -5, 0.45, 5 }, { -5, 5 }, { -5, 0.55, 5 }));
  }
}

TEST(Grids, ASideWithManyLoops)
{
  expectGood(comb(20), meshlines({ -1, 2 }, { -1, 2 }, { -1, 0.5, 2 }));
  expectGood(comb(20).turned(), meshlines({ -5, 5 }, { -5, 0.2, 5 }, { -5, 0.3, 5 }));
}

// The rest of the cube stays, with sides that belong to no boundary.
TEST(Grids, MeshlinesThatCutTheSurfaceOff)
{
  const GridSpec grid = meshlines({ 0.25, 0.5, 0.75 }, { -1, 0.3, 2 }, { -1, 0.6, 2 });
  const Meshed meshed = meshOf(cube(), grid);
  EXPECT_TRUE(isValid(meshed.mesh));
  EXPECT_NEAR(volumeOf(meshed.mesh), 0.5, 1e-8);
  EXPECT_NEAR(boundaryArea(meshed.mesh, NoBoundary), 2, 1e-8);
  EXPECT_NEAR(boundaryArea(meshed.mesh, 0), 0, 1e-8);
  EXPECT_NEAR(boundaryArea(meshed.mesh, 2), 0.5, 1e-8);
}

TEST(Grids, MeshlinesInsideTheSurfaceLeaveABlock)
{
  const std::vector<double> lines = { 0.2, 0.4, 0.7 };
  const Meshed meshed = meshOf(cube(), meshlines(lines, lines, lines));
  EXPECT_TRUE(isValid(meshed.mesh));
  EXPECT_EQ(meshed.mesh.cells(), 8U);
  EXPECT_NEAR(volumeOf(meshed.mesh), 0.125, 1e-8);
  EXPECT_NEAR(boundaryArea(meshed.mesh, NoBoundary), 1.5, 1e-8);
}

TEST(Grids, HalfASphere)
{
  const Soup soup = sphere(7, 1);
  const std::vector<double> lines = { -2, -0.5, 0, 0.7, 2 };
  for (const int levels : { 0, 1 })
  {
    const Meshed meshed =
      meshOf(soup, meshlines(lines, { -2, -0.7, 0 }, lines), asTheyAre(0, depth(levels)));
    EXPECT_TRUE(isValid(meshed.mesh));
    EXPECT_NEAR(volumeOf(meshed.mesh), soup.volume() / 2, 1e-8);
    EXPECT_NEAR(boundaryArea(meshed.mesh, 2), soup.area() / 6, 1e-8); // of six equal parts
    EXPECT_NEAR(boundaryArea(meshed.mesh, 0), soup.area() / 12, 1e-8);
    EXPECT_NEAR(boundaryArea(meshed.mesh, 3), 0, 1e-8);
    EXPECT_GT(boundaryArea(meshed.mesh, NoBoundary), 3);
  }
}

// Cut off in all directions, obliquely, and refined.
TEST(Grids, PartsOfShapes)
{
  for (const NamedShape& shape : cleanShapes())
  {
    SCOPED_TRACE(shape.name);
    const Vector low = shape.soup.low();
    const Vector high = shape.soup.high();
    GridSpec grid;
    for (int axis = 0; axis < 3; ++axis)
    {
      for (const double part : { 0.21, 0.47, 0.5, 0.83 })
      {
        grid.meshlines[axis].push_back(low[axis] + part * (high[axis] - low[axis]));
      }
    }
    try
    {
      EXPECT_TRUE(isValid(meshOf(shape.soup, grid).mesh));
      EXPECT_TRUE(isValid(meshOf(shape.soup, grid, asTheyAre(0, depth(1))).mesh));
    }
    catch (const Error& error) // nothing of the surface is between these meshlines, or thinner
    {
      EXPECT_TRUE(error.fault == Fault::FlawedSurface || error.fault == Fault::BadMeshlines ||
        error.fault == Fault::BadParameter)
        << error.what();
    }
  }
}
