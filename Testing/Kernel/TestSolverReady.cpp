// With the default properties no cell is left that section 3 or OpenFOAM's checkMesh refuses.
#include "Error.h"
#include "MeshChecker.h"
#include "QualityMeasures.h"

#include <gtest/gtest.h>

#include <algorithm>

namespace cartesian
{

namespace
{

class SolverReady : public ::testing::TestWithParam<NamedShape>
{
};

Options defaults()
{
  Options options;
  options.cells = CellSpec();
  options.patches = PatchSpec();
  return options;
}

Quality qualityOf(const MeshArrays& mesh)
{
  CellFaces faces;
  for (std::size_t cell = 0; cell < mesh.cells(); ++cell)
  {
    faces.firstFace.push_back(faces.firstCorner.size());
    for (const Face& face : facesOf(mesh, cell))
    {
      faces.firstCorner.push_back(faces.corners.size());
      faces.corners.insert(faces.corners.end(), face.begin(), face.end());
    }
  }
  faces.firstFace.push_back(faces.firstCorner.size());
  faces.firstCorner.push_back(faces.corners.size());
  Execution execution(1);
  const FaceList list = listFaces(faces, mesh.points.size() / 3, Clashes::AreBoundary, execution);
  return measureQuality(mesh.points.data(), faces, list, execution);
}

// Unless all cells are small (4.10), as those of a needle.
void expectReady(const Soup& soup, double cells, const Options& options)
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
}

}

TEST_P(SolverReady, NothingIsRefused)
{
  const Soup& soup = GetParam().soup;
  for (const double cells : { 3.3, 8.0 })
  {
    SCOPED_TRACE(cells);
    expectReady(soup, cells, defaults());
  }
}

TEST_P(SolverReady, NothingIsRefusedInRefinedMeshes)
{
  const Soup& soup = GetParam().soup;
  Options options = defaults();
  options.refinement = depth(2);
  expectReady(soup, 3.3, options);
}

INSTANTIATE_TEST_SUITE_P(Of, SolverReady, ::testing::ValuesIn(cleanShapes()), nameOf);

}
