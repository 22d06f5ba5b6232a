// SPDX-License-Identifier: BSD-3-Clause
#include "MeshUnion.h"

#include "BoundaryOfFaces.h"

#include "vtkAppendFilter.h"
#include "vtkCellData.h"
#include "vtkCellType.h"
#include "vtkDataSetAttributes.h"
#include "vtkExtractCells.h"
#include "vtkFieldData.h"
#include "vtkIdTypeArray.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkPoints.h"
#include "vtkUnsignedCharArray.h"
#include "vtkUnstructuredGrid.h"

#include <algorithm>
#include <array>

namespace cartesian
{

namespace
{

using Grids = std::vector<vtkSmartPointer<vtkUnstructuredGrid>>;

vtkIdTypeArray* pointIds(vtkUnstructuredGrid* grid)
{
  return vtkIdTypeArray::SafeDownCast(grid->GetPointData()->GetGlobalIds());
}

// As RemoveGhostCells(), which in VTK 9.6 allocates memory by a number that it never sets.
vtkSmartPointer<vtkUnstructuredGrid> withoutGhosts(vtkUnstructuredGrid* grid)
{
  vtkUnsignedCharArray* const ghosts = grid->GetCellGhostArray();
  if (!ghosts)
  {
    return grid;
  }
  std::vector<vtkIdType> own;
  for (vtkIdType cell = 0; cell < grid->GetNumberOfCells(); ++cell)
  {
    if ((ghosts->GetValue(cell) & vtkDataSetAttributes::DUPLICATECELL) == 0)
    {
      own.push_back(cell);
    }
  }
  vtkNew<vtkExtractCells> extract;
  extract->SetInputData(grid);
  extract->SetCellIds(own.data(), static_cast<vtkIdType>(own.size()));
  extract->AssumeSortedAndUniqueIdsOn();
  extract->Update();
  vtkSmartPointer<vtkUnstructuredGrid> rest = extract->GetOutput();
  if (pointIds(grid))
  {
    rest->GetPointData()->SetActiveGlobalIds(pointIds(grid)->GetName());
  }
  rest->GetFieldData()->PassData(grid->GetFieldData());
  rest->GetCellData()->RemoveArray(vtkDataSetAttributes::GhostArrayName());
  rest->GetPointData()->RemoveArray(vtkDataSetAttributes::GhostArrayName());
  return rest;
}

// The pieces that have cells, without ghosts.
Grids gridsOf(const std::vector<vtkSmartPointer<vtkDataObject>>& pieces)
{
  Grids grids;
  for (const auto& piece : pieces)
  {
    if (auto* grid = vtkUnstructuredGrid::SafeDownCast(piece))
    {
      if (const auto own = withoutGhosts(grid); own->GetNumberOfCells() > 0)
      {
        grids.push_back(own);
      }
    }
  }
  return grids;
}

vtkIdTypeArray* cellIds(vtkUnstructuredGrid* grid)
{
  return vtkIdTypeArray::SafeDownCast(grid->GetCellData()->GetAbstractArray(CellId));
}

vtkSmartPointer<vtkUnstructuredGrid> uniteByCoordinates(const Grids& grids)
{
  vtkNew<vtkAppendFilter> append;
  append->MergePointsOn();
  append->ToleranceIsAbsoluteOn();
  append->SetTolerance(0);
  for (const auto& grid : grids)
  {
    append->AddInputDataObject(grid);
  }
  append->Update();
  return append->GetOutput();
}

// The ids of all points, each once.
std::vector<vtkIdType> distinctPoints(const Grids& grids)
{
  std::vector<vtkIdType> ids;
  for (const auto& grid : grids)
  {
    const vtkIdType* first = pointIds(grid)->GetPointer(0);
    ids.insert(ids.end(), first, first + grid->GetNumberOfPoints());
  }
  std::sort(ids.begin(), ids.end());
  ids.erase(std::unique(ids.begin(), ids.end()), ids.end());
  return ids;
}

class UnionByIds
{
public:
  explicit UnionByIds(const Grids& grids)
    : grids_(grids)
    , ids_(distinctPoints(grids))
  {
  }

  vtkSmartPointer<vtkUnstructuredGrid> make()
  {
    addPoints();
    struct PointPlace
    {
      vtkIdType id;
      std::size_t grid;
      vtkIdType cell;
    };
    std::vector<PointPlace> places;
    vtkDataSetAttributes::FieldList fields(static_cast<int>(grids_.size()));
    for (std::size_t g = 0; g < grids_.size(); ++g)
    {
      fields.IntersectFieldList(grids_[g]->GetCellData());
      for (vtkIdType c = 0; c < grids_[g]->GetNumberOfCells(); ++c)
      {
        places.push_back({ cellIds(grids_[g])->GetValue(c), g, c });
      }
    }
    std::stable_sort(places.begin(), places.end(),
      [](const PointPlace& a, const PointPlace& b) { return a.id < b.id; });
    result_->Allocate(static_cast<vtkIdType>(places.size()));
    result_->GetCellData()->CopyGlobalIdsOn();
    fields.CopyAllocate(result_->GetCellData(), vtkDataSetAttributes::COPYTUPLE,
      static_cast<vtkIdType>(places.size()), 0);
    for (const PointPlace& place : places)
    {
      const vtkIdType cell = addCell(place.grid, place.cell);
      fields.CopyData(static_cast<int>(place.grid), grids_[place.grid]->GetCellData(), place.cell,
        result_->GetCellData(), cell);
    }
    return result_;
  }

private:
  vtkIdType pointOf(std::size_t grid, vtkIdType local) const
  {
    const vtkIdType id = pointIds(grids_[grid])->GetValue(local);
    return std::lower_bound(ids_.begin(), ids_.end(), id) - ids_.begin();
  }

  void addPoints()
  {
    vtkNew<vtkPoints> points;
    points->SetDataType(grids_.front()->GetPoints()->GetDataType());
    points->SetNumberOfPoints(static_cast<vtkIdType>(ids_.size()));
    for (std::size_t g = 0; g < grids_.size(); ++g)
    {
      for (vtkIdType p = 0; p < grids_[g]->GetNumberOfPoints(); ++p)
      {
        points->SetPoint(pointOf(g, p), grids_[g]->GetPoint(p));
      }
    }
    result_->SetPoints(points);
  }

  vtkIdType addCell(std::size_t g, vtkIdType cell)
  {
    vtkUnstructuredGrid* grid = grids_[g];
    if (grid->GetCellType(cell) != VTK_POLYHEDRON)
    {
      grid->GetCellPoints(cell, scratch_);
      for (vtkIdType i = 0; i < scratch_->GetNumberOfIds(); ++i)
      {
        scratch_->SetId(i, pointOf(g, scratch_->GetId(i)));
      }
      return result_->InsertNextCell(grid->GetCellType(cell), scratch_);
    }
    grid->GetFaceStream(cell, scratch_);
    vtkIdType at = 1;
    for (vtkIdType face = 0; face < scratch_->GetId(0); ++face)
    {
      const vtkIdType size = scratch_->GetId(at++);
      for (vtkIdType i = 0; i < size; ++i, ++at)
      {
        scratch_->SetId(at, pointOf(g, scratch_->GetId(at)));
      }
    }
    return result_->InsertNextCell(VTK_POLYHEDRON, scratch_);
  }

  const Grids& grids_;
  std::vector<vtkIdType> ids_;
  vtkSmartPointer<vtkUnstructuredGrid> result_ = vtkSmartPointer<vtkUnstructuredGrid>::New();
  vtkNew<vtkIdList> scratch_;
};

// Reads BoundaryOfFaces of all pieces, as cells may since have moved from one to another.
void uniteBoundaryOfFaces(
  const std::vector<vtkSmartPointer<vtkDataObject>>& pieces, vtkUnstructuredGrid* grid)
{
  std::vector<std::array<vtkIdType, 3>> rows;
  vtkSmartPointer<vtkIdTypeArray> united;
  for (const auto& piece : pieces)
  {
    auto* array = piece
      ? vtkIdTypeArray::SafeDownCast(piece->GetFieldData()->GetAbstractArray(BoundaryOfFaces))
      : nullptr;
    if (!array || array->GetNumberOfComponents() != 3)
    {
      continue;
    }
    united = vtk::TakeSmartPointer(array->NewInstance());
    united->SetName(BoundaryOfFaces);
    united->SetNumberOfComponents(3);
    for (int i = 0; i < 3; ++i)
    {
      united->SetComponentName(i, array->GetComponentName(i));
    }
    for (vtkIdType r = 0; r < array->GetNumberOfTuples(); ++r)
    {
      rows.emplace_back();
      array->GetTypedTuple(r, rows.back().data());
    }
  }
  if (!united)
  {
    return;
  }
  std::sort(rows.begin(), rows.end());
  rows.erase(std::unique(rows.begin(), rows.end()), rows.end());
  for (const auto& row : rows)
  {
    united->InsertNextTypedTuple(row.data());
  }
  grid->GetFieldData()->AddArray(united);
}

}

vtkSmartPointer<vtkUnstructuredGrid> unitePieces(
  const std::vector<vtkSmartPointer<vtkDataObject>>& pieces)
{
  const Grids grids = gridsOf(pieces);
  if (grids.empty())
  {
    return vtkSmartPointer<vtkUnstructuredGrid>::New();
  }
  const bool haveIds = std::all_of(
    grids.begin(), grids.end(), [](const auto& grid) { return pointIds(grid) && cellIds(grid); });
  vtkSmartPointer<vtkUnstructuredGrid> whole =
    haveIds ? UnionByIds(grids).make() : uniteByCoordinates(grids);
  whole->GetFieldData()->PassData(grids.front()->GetFieldData());
  uniteBoundaryOfFaces(pieces, whole);
  return whole;
}

}
