// Finite Volume Quality on VTK's cells: their faces, arrays and numbers. What the measures are worth
// is the kernel's tests' matter.
#include "vtkFiniteVolumeQuality.h"

#include "vtkCellArray.h"
#include "vtkCellData.h"
#include "vtkCellType.h"
#include "vtkDataArray.h"
#include "vtkFieldData.h"
#include "vtkNew.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"
#include "vtkUnsignedCharArray.h"
#include "vtkUnstructuredGrid.h"

#include <gtest/gtest.h>

#include <cmath>
#include <string>
#include <vector>

namespace
{

struct Cell
{
  std::string name;
  int type;
  std::vector<std::array<double, 3>> points; // in VTK's order
  double volume;
  vtkIdType faces;
};

std::ostream& operator<<(std::ostream& stream, const Cell& cell)
{
  return stream << cell.name;
}

// A regular prism of n sides on the unit circle, of height 1.
std::vector<std::array<double, 3>> prism(int n)
{
  std::vector<std::array<double, 3>> points;
  for (int z = 0; z < 2; ++z)
  {
    for (int i = 0; i < n; ++i)
    {
      const double angle = 2 * std::acos(-1.0) * i / n;
      points.push_back({ std::cos(angle), std::sin(angle), double(z) });
    }
  }
  return points;
}

double areaOfPrism(int n)
{
  return n / 2.0 * std::sin(2 * std::acos(-1.0) / n);
}

std::vector<Cell> linearCells()
{
  const std::array<double, 3> o{ 0, 0, 0 };
  const std::array<double, 3> x{ 1, 0, 0 };
  const std::array<double, 3> y{ 0, 1, 0 };
  const std::array<double, 3> z{ 0, 0, 1 };
  const std::array<double, 3> xy{ 1, 1, 0 };
  const std::array<double, 3> xz{ 1, 0, 1 };
  const std::array<double, 3> yz{ 0, 1, 1 };
  const std::array<double, 3> xyz{ 1, 1, 1 };
  return {
    { "Tetrahedron", VTK_TETRA, { o, x, y, z }, 1.0 / 6, 4 },
    { "Voxel", VTK_VOXEL, { o, x, y, xy, z, xz, yz, xyz }, 1, 6 },
    { "Hexahedron", VTK_HEXAHEDRON, { o, x, xy, y, z, xz, xyz, yz }, 1, 6 },
    { "Wedge", VTK_WEDGE, { o, y, x, z, yz, xz }, 1.0 / 2, 5 }, // the base's normal points out
    { "Pyramid", VTK_PYRAMID, { o, x, xy, y, z }, 1.0 / 3, 5 },
    { "PentagonalPrism", VTK_PENTAGONAL_PRISM, prism(5), areaOfPrism(5), 7 },
    { "HexagonalPrism", VTK_HEXAGONAL_PRISM, prism(6), areaOfPrism(6), 8 },
  };
}

void fill(vtkUnstructuredGrid* grid, const Cell& cell, int precision = VTK_DOUBLE)
{
  vtkNew<vtkPoints> points;
  points->SetDataType(precision);
  std::vector<vtkIdType> ids;
  for (const auto& p : cell.points)
  {
    ids.push_back(points->InsertNextPoint(p.data()));
  }
  grid->SetPoints(points);
  grid->Allocate(1);
  grid->InsertNextCell(cell.type, static_cast<vtkIdType>(ids.size()), ids.data());
}

double cellValue(vtkDataSet* data, const char* name, vtkIdType cell)
{
  vtkDataArray* array = data->GetCellData()->GetArray(name);
  return array ? array->GetComponent(cell, 0) : std::nan("");
}

double fieldValue(vtkDataSet* data, const char* name)
{
  vtkDataArray* array = data->GetFieldData()->GetArray(name);
  return array ? array->GetComponent(0, 0) : std::nan("");
}

class LinearCell : public ::testing::TestWithParam<Cell>
{
};

}

TEST_P(LinearCell, FacesPointOutward)
{
  const Cell& cell = GetParam();
  for (const int precision : { VTK_DOUBLE, VTK_FLOAT })
  {
    vtkNew<vtkUnstructuredGrid> grid;
    fill(grid, cell, precision);
    vtkNew<vtkFiniteVolumeQuality> quality;
    quality->SetInputData(grid);
    quality->Update();
    auto* mesh = vtkUnstructuredGrid::SafeDownCast(quality->GetOutputDataObject(0));
    auto* faces = vtkPolyData::SafeDownCast(quality->GetOutputDataObject(1));
    EXPECT_NEAR(cellValue(mesh, "Volume", 0), cell.volume, precision == VTK_FLOAT ? 1e-6 : 1e-12);
    EXPECT_EQ(cellValue(mesh, "OpenEdges", 0), 0);
    EXPECT_EQ(cellValue(mesh, "Concavity", 0), 0);
    EXPECT_LT(cellValue(mesh, "BoundaryAngle", 0), 90);
    EXPECT_EQ(faces->GetNumberOfCells(), cell.faces);
    EXPECT_EQ(cellValue(faces, "Owner", 0), 0);
    EXPECT_EQ(cellValue(faces, "Neighbour", 0), -1);
    EXPECT_EQ(fieldValue(mesh, "DeterminantFailures"), 1) << "no inner faces";
    EXPECT_EQ(quality->GetErrorCode(), 0u);
  }
}

INSTANTIATE_TEST_SUITE_P(FiniteVolumeQuality, LinearCell, ::testing::ValuesIn(linearCells()),
  [](const auto& parameter) { return parameter.param.name; });

TEST(FiniteVolumeQuality, FlatCellsAreNotMeasured)
{
  vtkNew<vtkUnstructuredGrid> grid;
  fill(grid, linearCells()[0]);
  const vtkIdType corners[] = { 0, 1, 2 };
  grid->InsertNextCell(VTK_TRIANGLE, 3, corners);
  vtkNew<vtkFiniteVolumeQuality> quality;
  quality->SetInputData(grid);
  quality->Update();
  auto* mesh = vtkUnstructuredGrid::SafeDownCast(quality->GetOutputDataObject(0));
  EXPECT_TRUE(std::isnan(cellValue(mesh, "Volume", 1)));
  EXPECT_EQ(cellValue(mesh, "Failures", 1), 0);
  EXPECT_EQ(cellValue(mesh, "Failures", 0), 1024);
  EXPECT_NEAR(fieldValue(mesh, "TotalVolume"), 1.0 / 6, 1e-12);
}

// Two hexahedra one upon the other along x, so thick, each of which leans along y by so much.
void fillWithTwo(vtkUnstructuredGrid* grid, double thickness, double lean)
{
  vtkNew<vtkPoints> points;
  grid->Allocate(2);
  for (int x = 0; x < 3; ++x)
  {
    for (int i = 0; i < 4; ++i)
    {
      points->InsertNextPoint(thickness * x, i % 2 + lean * x, i / 2);
    }
  }
  grid->SetPoints(points);
  for (vtkIdType c = 0; c < 2; ++c)
  {
    std::vector<vtkIdType> corners;
    for (const vtkIdType i : { 0, 4, 5, 1, 2, 6, 7, 3 })
    {
      corners.push_back(4 * c + i);
    }
    grid->InsertNextCell(VTK_HEXAHEDRON, 8, corners.data());
  }
}

// A face of these by 84 degrees.
TEST(FiniteVolumeQuality, LayersMayLean)
{
  constexpr int Code = 16; // of InnerAngle
  for (const int layer : { 0, 1 })
  {
    vtkNew<vtkUnstructuredGrid> grid;
    fillWithTwo(grid, 0.01, 0.1);
    vtkNew<vtkUnsignedCharArray> layers;
    layers->SetName("Layer");
    layers->InsertNextValue(static_cast<unsigned char>(layer));
    layers->InsertNextValue(0);
    grid->GetCellData()->AddArray(layers);
    vtkNew<vtkFiniteVolumeQuality> quality;
    quality->SetInputData(grid);
    quality->Update();
    auto* mesh = vtkUnstructuredGrid::SafeDownCast(quality->GetOutputDataObject(0));
    EXPECT_NEAR(cellValue(mesh, "InnerAngle", 0), 84.29, 0.01);
    EXPECT_EQ(static_cast<int>(cellValue(mesh, "Failures", 0)) & Code, layer == 0 ? Code : 0);
    EXPECT_EQ(static_cast<int>(cellValue(mesh, "Failures", 1)) & Code, Code);
  }
}

TEST(FiniteVolumeQuality, GhostsAreNeighboursOnly)
{
  vtkNew<vtkUnstructuredGrid> grid;
  fillWithTwo(grid, 1, 0);
  vtkNew<vtkUnsignedCharArray> ghosts;
  ghosts->SetName(vtkDataSetAttributes::GhostArrayName());
  ghosts->InsertNextValue(0);
  ghosts->InsertNextValue(vtkDataSetAttributes::DUPLICATECELL);
  grid->GetCellData()->AddArray(ghosts);
  vtkNew<vtkFiniteVolumeQuality> quality;
  quality->SetInputData(grid);
  quality->Update();
  auto* mesh = vtkUnstructuredGrid::SafeDownCast(quality->GetOutputDataObject(0));
  EXPECT_NEAR(cellValue(mesh, "FaceWeight", 0), 0.5, 1e-12);
  EXPECT_EQ(fieldValue(mesh, "Cells"), 1);
  EXPECT_NEAR(fieldValue(mesh, "TotalVolume"), 1, 1e-12);
  EXPECT_NEAR(fieldValue(mesh, "BoundaryArea"), 5, 1e-12);
}

TEST(FiniteVolumeQuality, CurvedCellsAreRefused)
{
  vtkNew<vtkUnstructuredGrid> grid;
  Cell cell = linearCells()[0];
  cell.type = VTK_QUADRATIC_TETRA;
  cell.points.resize(10, { 0.5, 0.5, 0.5 });
  fill(grid, cell);
  vtkNew<vtkFiniteVolumeQuality> quality;
  quality->SetInputData(grid);
  vtkObject::GlobalWarningDisplayOff();
  quality->Update();
  vtkObject::GlobalWarningDisplayOn();
  EXPECT_EQ(quality->GetErrorCode(), unsigned(vtkCartesianAlgorithm::BadMesh));
  EXPECT_EQ(
    vtkUnstructuredGrid::SafeDownCast(quality->GetOutputDataObject(0))->GetNumberOfCells(), 0);
}

TEST(FiniteVolumeQuality, AnEmptyGrid)
{
  vtkNew<vtkUnstructuredGrid> grid;
  vtkNew<vtkFiniteVolumeQuality> quality;
  quality->SetInputData(grid);
  quality->Update();
  auto* faces = vtkPolyData::SafeDownCast(quality->GetOutputDataObject(1));
  EXPECT_EQ(quality->GetErrorCode(), 0u);
  EXPECT_EQ(faces->GetNumberOfCells(), 0);
  EXPECT_EQ(fieldValue(faces, "Cells"), 0);
  EXPECT_EQ(fieldValue(faces, "FailingCells"), 0);
}
