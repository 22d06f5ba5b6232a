// With the default properties no cell is left that section 3 or OpenFOAM's checkMesh refuses.
#include "Base/Error.h"
#include "Polyhedra/CellGeometry.h"
#include "Polyhedra/Polyhedron.h"
#include "Support/MeshChecker.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <limits>
#include <map>

namespace cartesian
{

namespace
{

class SolverReady : public ::testing::TestWithParam<NamedShape>
{
};

Face nodesOf(Face face)
{
  std::sort(face.begin(), face.end());
  return face;
}

// Of how many cells each face is a part.
std::map<Face, int> usesOfFaces(const MeshArrays& mesh)
{
  std::map<Face, int> uses;
  for (std::size_t cell = 0; cell < mesh.cells(); ++cell)
  {
    for (const Face& face : facesOf(mesh, cell))
    {
      ++uses[nodesOf(face)];
    }
  }
  return uses;
}

// Faces that break a rule of section 3 by the centres that later versions of OpenFOAM give bent faces.
std::size_t failuresByProjectedCentres(const MeshArrays& mesh)
{
  const std::map<Face, int> uses = usesOfFaces(mesh);
  std::size_t failures = 0;
  for (std::size_t cell = 0; cell < mesh.cells(); ++cell)
  {
    Polyhedron polyhedron;
    for (const Face& face : facesOf(mesh, cell))
    {
      for (const Id point : face)
      {
        const double* const p = &mesh.points[3 * static_cast<std::size_t>(point)];
        polyhedron.addCorner(static_cast<std::uint32_t>(polyhedron.nodes.size()));
        polyhedron.nodes.push_back({ p[0], p[1], p[2] });
      }
      polyhedron.closeFace(uses.at(nodesOf(face)) == 1);
    }
    CellShape shape;
    measureProjected(polyhedron, shape);
    for (std::size_t f = 0; f < polyhedron.faces(); ++f)
    {
      const double degrees = angle(minus(shape.faces[f].centre, shape.centre), shape.faces[f].area);
      failures += degrees >= (polyhedron.isBoundary[f] != 0 ? 90 : 75) ? 1 : 0;
    }
  }
  return failures;
}

// Unless all cells are small (4.10), as those of a needle.
void expectReady(const Soup& soup, double cells, const TestOptions& options)
{
  MeshArrays mesh;
  try
  {
    mesh = meshOf(soup, cellsAlongLongest(soup, cells), options).mesh;
  }
  catch (const Error& error)
  {
    EXPECT_EQ(std::string(error.what()).find("There is nothing left to mesh: all "), 0U);
    return;
  }
  EXPECT_TRUE(isValid(mesh, true));
  EXPECT_EQ(std::count(mesh.boundaryIndex.begin(), mesh.boundaryIndex.end(), NoBoundary), 0);
  const Quality quality = qualityOf(mesh);
  for (const Measure measure : { BoundaryAngle, InnerAngle, StarTriangulation, Skewness })
  {
    std::size_t failing = 0;
    for (const double value : quality.cells[measure])
    {
      failing += fails(measure, value) ? 1 : 0;
    }
    EXPECT_EQ(failing, 0U) << MeasureSpecs[measure].name;
  }
  EXPECT_EQ(failuresByProjectedCentres(mesh), 0U);
}

}

TEST_P(SolverReady, NothingIsRefused)
{
  const Soup& soup = GetParam().soup;
  for (const double cells : { 3.3, 8.0 })
  {
    SCOPED_TRACE(cells);
    expectReady(soup, cells, TestOptions());
  }
}

TEST_P(SolverReady, NothingIsRefusedInRefinedMeshes)
{
  const Soup& soup = GetParam().soup;
  TestOptions options;
  options.refinement = depth(2);
  expectReady(soup, 3.3, options);
}

// Mending moves next to no volume, where it leaves out nothing.
TEST(SolverReady, MendingKeepsTheVolume)
{
  for (const unsigned seed : { 1U, 2U, 3U })
  {
    for (const double cells : { 6.0, 10.0 })
    {
      SCOPED_TRACE(seed);
      const Soup soup = bumpySphere(seed, 24);
      TestOptions asCut;
      asCut.smallCells.handling = SmallCells::Remove;
      asCut.smallCells.ratio = 1e-9;
      asCut.shaping.splitConcave = false;
      const GridSpec grid = cellsAlongLongest(soup, cells);
      const double volume = volumeOf(meshOf(soup, grid, asCut).mesh);
      TestOptions mended;
      mended.shaping.refusedCellRatio = 0;
      EXPECT_NEAR(volumeOf(meshOf(soup, grid, mended).mesh), volume, 5e-3 * volume);
    }
  }
}

// Walls that lean by next to nothing from planes of the grid, and are boundaries of their own, leave strips in
// the cells beside them; these become a part of the faces next to them.
TEST(SolverReady, NoBoundaryFaceIsNegligible)
{
  for (const double degrees : { 0.0, 1e-6, 1e-5 })
  {
    SCOPED_TRACE(degrees);
    Soup soup = cube();
    soup.add(box({ 1, 0.25, 0.25 }, { 1.5, 0.5, 0.75 }));
    const MeshArrays mesh = meshOf(soup.turned(2, degrees), cellsAlongLongest(soup, 12), {}).mesh;
    const std::map<Face, int> uses = usesOfFaces(mesh);
    for (std::size_t cell = 0; cell < mesh.cells(); ++cell)
    {
      double smallest = std::numeric_limits<double>::max(); // at the boundary
      double largest = 0;
      for (const Face& face : facesOf(mesh, cell))
      {
        const auto corner = [&](std::size_t i) {
          const double* const p = &mesh.points[3 * static_cast<std::size_t>(face[i])];
          return Vector{ p[0], p[1], p[2] };
        };
        const double area = norm(measureFace(face.size(), corner).area);
        largest = std::max(largest, area);
        smallest = uses.at(nodesOf(face)) == 1 ? std::min(smallest, area) : smallest;
      }
      EXPECT_GE(smallest, 1e-4 * largest) << cell;
    }
  }
}

INSTANTIATE_TEST_SUITE_P(Of, SolverReady, ::testing::ValuesIn(cleanShapes()), nameOf);

}
