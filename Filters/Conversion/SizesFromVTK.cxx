// SPDX-License-Identifier: BSD-3-Clause
#include "SizesFromVTK.h"

#include "SurfaceBlocks.h"

#include "vtkCellData.h"
#include "vtkCellType.h"
#include "vtkCompositeDataIterator.h"
#include "vtkCompositeDataSet.h"
#include "vtkDataArray.h"
#include "vtkIdList.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkPolyData.h"
#include "vtkSmartPointer.h"

#include <algorithm>
#include <cmath>

namespace cartesian
{

namespace
{

// 0: no effect.
double sizeAt(vtkDataArray* array, vtkIdType i)
{
  const double value = array->GetComponent(i, 0);
  return std::isfinite(value) && value > 0 ? value : 0;
}

// The array in one data set: of its cells, or else of its points.
class Sizes
{
public:
  Sizes(vtkDataSet* data, const std::string& name)
    : data_(data)
    , ofCells_(found(data->GetCellData(), name, data->GetNumberOfCells()))
    , ofPoints_(ofCells_ ? nullptr : found(data->GetPointData(), name, data->GetNumberOfPoints()))
  {
  }

  bool any() const { return ofCells_ || ofPoints_; }
  bool areOfPoints() const { return ofPoints_ != nullptr; }
  double ofPoint(vtkIdType point) const { return ofPoints_ ? sizeAt(ofPoints_, point) : 0; }

  double ofCell(vtkIdType cell) const
  {
    if (ofCells_)
    {
      return sizeAt(ofCells_, cell);
    }
    data_->GetCellPoints(cell, points_);
    double least = 0;
    for (vtkIdType i = 0; ofPoints_ && i < points_->GetNumberOfIds(); ++i)
    {
      const double size = sizeAt(ofPoints_, points_->GetId(i));
      least = size > 0 && (least == 0 || size < least) ? size : least;
    }
    return least;
  }

private:
  static vtkDataArray* found(vtkFieldData* attributes, const std::string& name, vtkIdType count)
  {
    vtkDataArray* array = attributes->GetArray(name.c_str());
    return array && array->GetNumberOfComponents() == 1 && array->GetNumberOfTuples() == count
      ? array
      : nullptr;
  }

  vtkDataSet* data_;
  vtkDataArray* ofCells_;
  vtkDataArray* ofPoints_;
  vtkNew<vtkIdList> points_;
};

std::vector<vtkDataSet*> leaves(vtkDataObject* field)
{
  if (auto* data = vtkDataSet::SafeDownCast(field))
  {
    return { data };
  }
  std::vector<vtkDataSet*> result;
  if (auto* blocks = vtkCompositeDataSet::SafeDownCast(field))
  {
    auto each = vtk::TakeSmartPointer(blocks->NewIterator());
    for (each->InitTraversal(); !each->IsDoneWithTraversal(); each->GoToNextItem())
    {
      if (auto* data = vtkDataSet::SafeDownCast(each->GetCurrentDataObject()))
      {
        result.push_back(data);
      }
    }
  }
  return result;
}

void addPoint(vtkDataSet* data, vtkIdType point, double size, std::vector<WantedSize>& result)
{
  if (size > 0)
  {
    std::array<double, 3> at;
    data->GetPoint(point, at.data());
    result.push_back({ at, at, size });
  }
}

// Many points may be one cell, such as a cloud: each prescribes its own size.
bool isCloud(int type)
{
  return type == VTK_VERTEX || type == VTK_POLY_VERTEX;
}

void addSizes(vtkDataSet* data, const Sizes& sizes, std::vector<WantedSize>& result)
{
  vtkNew<vtkIdList> points;
  for (vtkIdType cell = 0; cell < data->GetNumberOfCells(); ++cell)
  {
    if (isCloud(data->GetCellType(cell)))
    {
      data->GetCellPoints(cell, points);
      for (vtkIdType i = 0; i < points->GetNumberOfIds(); ++i)
      {
        const vtkIdType point = points->GetId(i);
        addPoint(
          data, point, sizes.areOfPoints() ? sizes.ofPoint(point) : sizes.ofCell(cell), result);
      }
    }
    else if (const double size = sizes.ofCell(cell); size > 0)
    {
      std::array<double, 6> bounds;
      data->GetCellBounds(cell, bounds.data());
      result.push_back(
        { { bounds[0], bounds[2], bounds[4] }, { bounds[1], bounds[3], bounds[5] }, size });
    }
  }
  for (vtkIdType point = 0; data->GetNumberOfCells() == 0 && point < data->GetNumberOfPoints();
       ++point)
  {
    addPoint(data, point, sizes.ofPoint(point), result);
  }
}

}

AskedSizes sizesOnSurface(
  const std::string& array, vtkDataObject* surface, const std::vector<vtkIdType>& cells)
{
  AskedSizes asked;
  std::vector<double> ofCells;
  for (const SurfaceBlock& block : surfaceBlocks(surface))
  {
    const Sizes sizes(block.surface, array);
    asked.isThere = asked.isThere || sizes.any();
    for (vtkIdType cell = 0; cell < block.surface->GetNumberOfCells(); ++cell)
    {
      ofCells.push_back(sizes.any() ? sizes.ofCell(cell) : 0);
    }
  }
  asked.ofTriangles.reserve(cells.size());
  for (const vtkIdType cell : cells)
  {
    asked.ofTriangles.push_back(cell < 0 ? 0 : ofCells[static_cast<std::size_t>(cell)]);
  }
  return asked;
}

AskedSizes sizesInField(const std::string& array, vtkDataObject* field)
{
  AskedSizes asked;
  for (vtkDataSet* data : leaves(field))
  {
    const Sizes sizes(data, array);
    asked.isThere = asked.isThere || sizes.any();
    if (sizes.any())
    {
      addSizes(data, sizes, asked.boxes);
    }
  }
  return asked;
}

}
