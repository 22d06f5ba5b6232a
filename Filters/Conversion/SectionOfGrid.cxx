// SPDX-License-Identifier: BSD-3-Clause
#include "SectionOfGrid.h"

#include "GridFaces.h"

#include "Base/Sorting.h"

#include "vtkCellArray.h"
#include "vtkCellData.h"
#include "vtkDoubleArray.h"
#include "vtkFieldData.h"
#include "vtkIdTypeArray.h"
#include "vtkPointData.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"
#include "vtkUnstructuredGrid.h"

#include <algorithm>
#include <limits>

namespace cartesian
{

namespace
{

constexpr std::size_t ItemsAChunk = 4096;

}

SectionOfGrid::SectionOfGrid(vtkUnstructuredGrid* grid, const Vector& origin, const Vector& normal)
  : grid_(grid)
  , origin_(origin)
  , normal_(normal)
  , points_(coordinatesOf(grid, copy_))
{
}

void SectionOfGrid::add(double offset, Execution& execution)
{
  if (heights_.empty())
  {
    findHeights(execution);
  }
  std::vector<double> heights(heights_.size());
  execution.forEach(heights.size(), ItemsAChunk, [&](std::size_t begin, std::size_t end) {
    for (std::size_t i = begin; i < end; ++i)
    {
      heights[i] = heights_[i] - offset;
    }
  });
  Part part;
  part.offset = offset;
  part.cut = cutCells(offset, execution);
  CellFaces faces = facesOfCells(grid_, part.cut, execution);
  turnOutward(faces, points_, execution);
  part.section = planeSection(faces, points_, heights, { origin_, normal_, offset }, execution);
  if (grid_->GetPointData()->GetNumberOfArrays() > 0)
  {
    part.sums = sumsOf(part.section, faces, points_, execution);
  }
  parts_.push_back(std::move(part));
}

void SectionOfGrid::findHeights(Execution& execution)
{
  const SectionPlane plane{ origin_, normal_, 0 };
  heights_.resize(static_cast<std::size_t>(grid_->GetNumberOfPoints()));
  execution.forEach(heights_.size(), ItemsAChunk, [&](std::size_t begin, std::size_t end) {
    for (std::size_t i = begin; i < end; ++i)
    {
      const double* p = points_ + 3 * i;
      heights_[i] = plane.height({ p[0], p[1], p[2] });
    }
  });
  const auto count = static_cast<std::size_t>(grid_->GetNumberOfCells());
  lowest_.assign(count, std::numeric_limits<double>::infinity());
  highest_.assign(count, -std::numeric_limits<double>::infinity());
  execution.forEach(count, ItemsAChunk, [&](std::size_t begin, std::size_t end) {
    auto cells = vtk::TakeSmartPointer(grid_->GetCells()->NewIterator());
    for (std::size_t cell = begin; cell < end; ++cell)
    {
      vtkIdType size = 0;
      const vtkIdType* corners = nullptr;
      cells->GetCellAtId(static_cast<vtkIdType>(cell), size, corners);
      for (vtkIdType i = 0; i < size; ++i)
      {
        const double height = heights_[static_cast<std::size_t>(corners[i])];
        lowest_[cell] = std::min(lowest_[cell], height);
        highest_[cell] = std::max(highest_[cell], height);
      }
    }
  });
}

// Those with points on both sides.
std::vector<vtkIdType> SectionOfGrid::cutCells(double offset, Execution& execution) const
{
  std::vector<std::vector<vtkIdType>> found(chunks(lowest_.size(), ItemsAChunk));
  execution.forEach(lowest_.size(), ItemsAChunk, [&](std::size_t begin, std::size_t end) {
    for (std::size_t cell = begin; cell < end; ++cell)
    {
      if (lowest_[cell] - offset < 0 && highest_[cell] - offset >= 0)
      {
        found[begin / ItemsAChunk].push_back(static_cast<vtkIdType>(cell));
      }
    }
  });
  return concatenated(found);
}

void SectionOfGrid::write(vtkPolyData* output) const
{
  writePoints(output);
  writePolygons(output);
  output->GetFieldData()->PassData(grid_->GetFieldData());
}

void SectionOfGrid::writePoints(vtkPolyData* output) const
{
  vtkIdType count = 0;
  for (const Part& part : parts_)
  {
    count += static_cast<vtkIdType>(part.section.points.size());
  }
  vtkNew<vtkPoints> points;
  points->SetDataTypeToDouble();
  points->SetNumberOfPoints(count);
  vtkPointData* from = grid_->GetPointData();
  vtkPointData* to = output->GetPointData();
  to->InterpolateAllocate(from, count);
  const bool hasData = from->GetNumberOfArrays() > 0;
  vtkNew<vtkIdList> ids;
  vtkIdType id = 0;
  for (const Part& part : parts_)
  {
    const PointSums& sums = part.sums;
    for (std::size_t i = 0; i < part.section.points.size(); ++i, ++id)
    {
      points->SetPoint(id, part.section.points[i].data());
      if (!hasData)
      {
        continue;
      }
      ids->Reset();
      for (std::size_t term = sums.first[i]; term < sums.first[i + 1]; ++term)
      {
        ids->InsertNextId(sums.point[term]);
      }
      to->InterpolatePoint(from, id, ids, const_cast<double*>(sums.weight.data() + sums.first[i]));
    }
  }
  output->SetPoints(points);
}

void SectionOfGrid::writePolygons(vtkPolyData* output) const
{
  vtkNew<vtkCellArray> polygons;
  vtkNew<vtkIdTypeArray> original;
  original->SetName("OriginalCellId");
  vtkNew<vtkDoubleArray> offsets;
  offsets->SetName("PlaneOffset");
  vtkIdType firstPoint = 0;
  for (const Part& part : parts_)
  {
    const PlaneSection& section = part.section;
    for (std::size_t i = 0; i < section.count(); ++i)
    {
      const std::size_t end = section.firstCorner[i + 1];
      polygons->InsertNextCell(static_cast<int>(end - section.firstCorner[i]));
      for (std::size_t corner = section.firstCorner[i]; corner < end; ++corner)
      {
        polygons->InsertCellPoint(firstPoint + section.corners[corner]);
      }
      original->InsertNextValue(part.cut[section.cell[i]]);
      offsets->InsertNextValue(part.offset);
    }
    firstPoint += static_cast<vtkIdType>(section.points.size());
  }
  output->SetPolys(polygons);
  vtkCellData* from = grid_->GetCellData();
  vtkCellData* to = output->GetCellData();
  vtkNew<vtkIdList> ids;
  ids->SetArray(original->GetPointer(0), original->GetNumberOfValues());
  to->CopyAllocate(from, original->GetNumberOfValues());
  vtkNew<vtkIdList> places;
  places->SetNumberOfIds(original->GetNumberOfValues());
  for (vtkIdType i = 0; i < places->GetNumberOfIds(); ++i)
  {
    places->SetId(i, i);
  }
  to->CopyData(from, ids, places);
  ids->Release();
  to->AddArray(original);
  if (parts_.size() > 1)
  {
    to->AddArray(offsets);
  }
}

}
