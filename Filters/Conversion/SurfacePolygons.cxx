// SPDX-License-Identifier: BSD-3-Clause
#include "SurfacePolygons.h"

#include "Lattice/Vector.h"

#include "vtkCellArray.h"
#include "vtkCellArrayIterator.h"
#include "vtkCellData.h"
#include "vtkDataSetAttributes.h"
#include "vtkIdTypeArray.h"
#include "vtkNew.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"
#include "vtkTriangleFilter.h"
#include "vtkUnsignedCharArray.h"

#include <algorithm>
#include <array>

namespace cartesian
{

bool allTriangles(vtkPolyData* input)
{
  return input->GetNumberOfStrips() == 0 && input->GetPolys()->GetMaxCellSize() <= 3;
}

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

std::vector<bool> hiddenCells(vtkPolyData* block)
{
  constexpr int HiddenCell = vtkDataSetAttributes::HIDDENCELL | vtkDataSetAttributes::REFINEDCELL |
    vtkDataSetAttributes::DUPLICATECELL;
  vtkUnsignedCharArray* cells = block->GetCellGhostArray();
  vtkUnsignedCharArray* points = block->GetPointGhostArray();
  if (!cells && !points)
  {
    return {};
  }
  std::vector<bool> hidden;
  for (vtkCellArray* kind :
    { block->GetVerts(), block->GetLines(), block->GetPolys(), block->GetStrips() })
  {
    auto cell = vtk::TakeSmartPointer(kind->NewIterator());
    for (cell->GoToFirstCell(); !cell->IsDoneWithTraversal(); cell->GoToNextCell())
    {
      vtkIdType size = 0;
      const vtkIdType* corners = nullptr;
      cell->GetCurrentCell(size, corners);
      const auto isHidden = [&](vtkIdType point) {
        return (points->GetValue(point) & vtkDataSetAttributes::HIDDENPOINT) != 0;
      };
      const auto id = static_cast<vtkIdType>(hidden.size());
      hidden.push_back((cells && (cells->GetValue(id) & HiddenCell) != 0) ||
        (points && std::any_of(corners, corners + size, isHidden)));
    }
  }
  return hidden;
}

std::size_t differentCorners(vtkPoints* points, vtkIdType size, const vtkIdType* corners)
{
  std::size_t count = 0;
  for (vtkIdType i = 0; i < size; ++i)
  {
    std::array<double, 3> a;
    std::array<double, 3> b;
    points->GetPoint(corners[i], a.data());
    points->GetPoint(corners[(i + 1) % size], b.data());
    count += a != b;
  }
  return count;
}

bool isFlat(vtkPoints* points, vtkIdType size, const vtkIdType* corners)
{
  std::array<Vector, 3> p;
  points->GetPoint(corners[0], p[0].data());
  for (vtkIdType i = 2; i < size; ++i)
  {
    points->GetPoint(corners[i - 1], p[1].data());
    points->GetPoint(corners[i], p[2].data());
    const Vector area = cross(minus(p[1], p[0]), minus(p[2], p[0]));
    if (area[0] != 0 || area[1] != 0 || area[2] != 0)
    {
      return false;
    }
  }
  return true;
}

}
