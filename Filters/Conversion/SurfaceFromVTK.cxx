// SPDX-License-Identifier: BSD-3-Clause
#include "SurfaceFromVTK.h"

#include "Error.h"

#include "vtkCellArray.h"
#include "vtkCellArrayIterator.h"
#include "vtkCellData.h"
#include "vtkDataArray.h"
#include "vtkIdTypeArray.h"
#include "vtkNew.h"
#include "vtkPolyData.h"
#include "vtkSmartPointer.h"
#include "vtkTriangleFilter.h"

#include <cmath>
#include <limits>

namespace cartesian
{

namespace
{

constexpr const char* CellIds = "CartesianMesherCellIds";

bool allTriangles(vtkPolyData* input)
{
  return input->GetNumberOfStrips() == 0 && input->GetPolys()->GetMaxCellSize() <= 3;
}

// The same surface in triangles; CellIds tells what cell of the input each is from.
vtkSmartPointer<vtkPolyData> triangulated(vtkPolyData* input)
{
  vtkNew<vtkPolyData> numbered;
  numbered->ShallowCopy(input);
  vtkNew<vtkIdTypeArray> ids;
  ids->SetName(CellIds);
  for (vtkIdType i = 0; i < input->GetNumberOfCells(); ++i)
  {
    ids->InsertNextValue(i);
  }
  numbered->GetCellData()->AddArray(ids);
  vtkNew<vtkTriangleFilter> filter;
  filter->SetInputData(numbered);
  filter->PassVertsOff();
  filter->PassLinesOff();
  filter->Update();
  return filter->GetOutput();
}

}

SurfaceFromVTK::SurfaceFromVTK(vtkPolyData* input, const std::string& boundaryArray)
{
  if (!input || !input->GetPoints() || input->GetNumberOfPolys() + input->GetNumberOfStrips() == 0)
  {
    throw Error(
      Fault::EmptySurface, "The surface has no polygons: connect a closed triangulated surface.");
  }
  if (input->GetNumberOfPoints() >= std::numeric_limits<std::uint32_t>::max())
  {
    throw Error(
      Fault::BadParameter, "The surface has more points than can be numbered in 32 bits.");
  }
  readTriangles(input);
  readBoundaries(input, boundaryArray);
}

void SurfaceFromVTK::readTriangles(vtkPolyData* input)
{
  vtkSmartPointer<vtkPolyData> surface = input;
  vtkIdTypeArray* ids = nullptr;
  if (!allTriangles(input))
  {
    surface = triangulated(input);
    ids = vtkIdTypeArray::SafeDownCast(surface->GetCellData()->GetArray(CellIds));
  }
  const vtkIdType before = surface->GetNumberOfVerts() + surface->GetNumberOfLines();
  auto cell = vtk::TakeSmartPointer(surface->GetPolys()->NewIterator());
  triangles_.reserve(3 * static_cast<std::size_t>(surface->GetNumberOfPolys()));
  cells_.reserve(static_cast<std::size_t>(surface->GetNumberOfPolys()));
  for (cell->GoToFirstCell(); !cell->IsDoneWithTraversal(); cell->GoToNextCell())
  {
    vtkIdType size = 0;
    const vtkIdType* corners = nullptr;
    cell->GetCurrentCell(size, corners);
    if (size != 3)
    {
      continue; // a polygon of fewer corners has no area
    }
    for (int i = 0; i < 3; ++i)
    {
      triangles_.push_back(static_cast<std::uint32_t>(corners[i]));
    }
    const vtkIdType id = before + cell->GetCurrentCellId();
    cells_.push_back(ids ? ids->GetValue(id) : id);
  }
  points_.resize(3 * static_cast<std::size_t>(surface->GetNumberOfPoints()));
  for (vtkIdType i = 0; i < surface->GetNumberOfPoints(); ++i)
  {
    surface->GetPoint(i, points_.data() + 3 * i);
  }
}

void SurfaceFromVTK::readBoundaries(vtkPolyData* input, const std::string& boundaryArray)
{
  boundary_.assign(cells_.size(), 0);
  const std::string name = boundaryArray.empty() ? StlSolids : boundaryArray;
  vtkDataArray* array = input->GetCellData()->GetArray(name.c_str());
  if (!array && boundaryArray.empty())
  {
    return;
  }
  if (!array || array->GetNumberOfComponents() != 1 ||
    array->GetNumberOfTuples() != input->GetNumberOfCells())
  {
    throw Error(Fault::MissingArray,
      "Boundary Array \"" + name +
        "\" is no cell array of the surface with one number a cell: choose another, or none.");
  }
  for (std::size_t t = 0; t < cells_.size(); ++t)
  {
    const double value = array->GetComponent(cells_[t], 0);
    if (!(std::abs(value) <= std::numeric_limits<std::int32_t>::max()))
    {
      throw Error(Fault::MissingArray,
        "Boundary Array \"" + name + "\" holds " + number(value) + " at cell " +
          std::to_string(cells_[t]) + ", which is no boundary number.");
    }
    boundary_[t] = static_cast<std::int32_t>(std::lround(value));
  }
}

SurfaceView SurfaceFromVTK::view() const
{
  return { points_.data(), points_.size() / 3, triangles_.data(), cells_.size(), boundary_.data(),
    cells_.data() };
}

}
