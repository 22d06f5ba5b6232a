// SPDX-License-Identifier: BSD-3-Clause
#include "MeshValues.h"

#include "Base/Error.h"
#include "Base/Words.h"

#include "vtkCellArray.h"
#include "vtkCellData.h"
#include "vtkDataArray.h"
#include "vtkIdList.h"
#include "vtkNew.h"
#include "vtkPolyData.h"
#include "vtkUnsignedCharArray.h"
#include "vtkUnstructuredGrid.h"

#include <algorithm>

namespace cartesian
{

namespace
{

bool isGhost(vtkUnstructuredGrid* mesh, vtkIdType cell)
{
  vtkUnsignedCharArray* ghosts = mesh->GetCellGhostArray();
  return ghosts && ghosts->GetValue(cell) != 0;
}

std::vector<double> ofCells(vtkUnstructuredGrid* mesh, vtkDataArray* array)
{
  std::vector<double> values;
  for (vtkIdType cell = 0; cell < mesh->GetNumberOfCells(); ++cell)
  {
    if (!isGhost(mesh, cell))
    {
      values.push_back(array->GetComponent(cell, 0));
    }
  }
  return values;
}

// The area of the largest boundary face of each cell.
std::vector<double> wallAreas(vtkUnstructuredGrid* mesh, vtkPolyData* faces)
{
  std::vector<double> areas(static_cast<std::size_t>(mesh->GetNumberOfCells()));
  vtkDataArray* owners = faces->GetCellData()->GetArray("Owner");
  vtkDataArray* neighbours = faces->GetCellData()->GetArray("Neighbour");
  vtkNew<vtkIdList> corners;
  for (vtkIdType face = 0; face < faces->GetNumberOfCells(); ++face)
  {
    if (neighbours->GetComponent(face, 0) < 0)
    {
      faces->GetPolys()->GetCellAtId(face, corners);
      const auto corner = [&](std::size_t i) {
        Vector at;
        faces->GetPoint(corners->GetId(static_cast<vtkIdType>(i)), at.data());
        return at;
      };
      double& largest = areas[static_cast<std::size_t>(owners->GetComponent(face, 0))];
      largest = std::max(largest,
        norm(measureFace(static_cast<std::size_t>(corners->GetNumberOfIds()), corner).area));
    }
  }
  return areas;
}

std::vector<double> firstHeights(vtkUnstructuredGrid* mesh, vtkPolyData* faces, vtkDataArray* layer)
{
  vtkDataArray* volumes = mesh->GetCellData()->GetArray(MeasureSpecs[Volume].name);
  const std::vector<double> areas = wallAreas(mesh, faces);
  std::vector<double> heights;
  for (vtkIdType cell = 0; cell < mesh->GetNumberOfCells(); ++cell)
  {
    const double area = areas[static_cast<std::size_t>(cell)];
    if (layer->GetComponent(cell, 0) == 1 && area > 0 && !isGhost(mesh, cell))
    {
      heights.push_back(volumes->GetComponent(cell, 0) / area);
    }
  }
  return heights;
}

}

std::optional<MeshValues> valuesOf(vtkUnstructuredGrid* mesh, vtkPolyData* faces, std::size_t which)
{
  vtkCellData* data = mesh->GetCellData();
  if (which == FirstLayerHeight)
  {
    vtkDataArray* layer = data->GetArray("Layer");
    return layer
      ? std::optional(MeshValues{ "First Layer Height", "", 0, firstHeights(mesh, faces, layer) })
      : std::nullopt;
  }
  const std::string array = which == VolumeFraction ? "VolumeFraction" : MeasureSpecs[which].name;
  vtkDataArray* values = data->GetArray(array.c_str());
  if (!values)
  {
    return std::nullopt;
  }
  MeshValues result{ wordsOf(array), "", 0, ofCells(mesh, values) };
  if (which < MeasureCount && MeasureSpecs[which].limit != NoLimit)
  {
    const MeasureSpec& spec = MeasureSpecs[which];
    result.limit =
      (spec.largeIsWorse ? "limit: at most " : "limit: at least ") + number(spec.limit);
    result.limitAt = spec.limit;
  }
  return result;
}

}
