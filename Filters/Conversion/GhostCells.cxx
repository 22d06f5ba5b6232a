// SPDX-License-Identifier: BSD-3-Clause
#include "GhostCells.h"

#include "Processes.h"

#include "vtkBoundingBox.h"
#include "vtkCellArray.h"
#include "vtkCellData.h"
#include "vtkCellType.h"
#include "vtkExtractCells.h"
#include "vtkGhostCellsGenerator.h"
#include "vtkIdList.h"
#include "vtkIdTypeArray.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkPoints.h"
#include "vtkUnsignedCharArray.h"
#include "vtkUnstructuredGrid.h"

#include <algorithm>
#include <numeric>

namespace cartesian
{

namespace
{

// What the bounds of this piece and of each other one have in common.
std::vector<vtkBoundingBox> overlaps(vtkUnstructuredGrid* mesh, const Processes& processes)
{
  vtkBoundingBox mine; // nothing, where there are no points
  for (vtkIdType p = 0; p < mesh->GetNumberOfPoints(); ++p)
  {
    mine.AddPoint(mesh->GetPoint(p));
  }
  std::vector<double> bounds(6);
  mine.GetBounds(bounds.data());
  std::vector<vtkBoundingBox> found;
  std::size_t same = 0;
  for (const std::vector<double>& other : processes.gather(bounds))
  {
    vtkBoundingBox box(other.data());
    same += other == bounds ? 1 : 0;
    if (box.IsValid() && mine.IsValid() && box.IntersectBox(mine) && (other != bounds || same > 1))
    {
      found.push_back(box);
    }
  }
  return found;
}

bool isIn(const vtkBoundingBox& box, const double point[3])
{
  const double* low = box.GetMinPoint();
  const double* high = box.GetMaxPoint();
  for (int axis = 0; axis < 3; ++axis)
  {
    if (point[axis] < low[axis] || point[axis] > high[axis])
    {
      return false;
    }
  }
  return true;
}

// The cells that can be ghosts elsewhere, or have a point of one.
std::vector<vtkIdType> cellsNear(
  vtkUnstructuredGrid* mesh, const std::vector<vtkBoundingBox>& boxes, int levels)
{
  std::vector<std::uint8_t> isNear(static_cast<std::size_t>(mesh->GetNumberOfPoints()));
  for (vtkIdType p = 0; p < mesh->GetNumberOfPoints(); ++p)
  {
    double point[3];
    mesh->GetPoint(p, point);
    isNear[static_cast<std::size_t>(p)] = std::any_of(
      boxes.begin(), boxes.end(), [&](const vtkBoundingBox& box) { return isIn(box, point); });
  }
  std::vector<vtkIdType> cells;
  for (int level = 0; level < levels; ++level)
  {
    cells.clear();
    const std::vector<std::uint8_t> before = isNear;
    for (vtkIdType c = 0; c < mesh->GetNumberOfCells(); ++c)
    {
      vtkIdType count = 0;
      const vtkIdType* points = nullptr;
      mesh->GetCells()->GetCellAtId(c, count, points);
      if (std::any_of(points, points + count,
            [&](vtkIdType p) { return before[static_cast<std::size_t>(p)] != 0; }))
      {
        cells.push_back(c);
        std::for_each(
          points, points + count, [&](vtkIdType p) { isNear[static_cast<std::size_t>(p)] = 1; });
      }
    }
  }
  return cells;
}

vtkSmartPointer<vtkUnstructuredGrid> withGhosts(
  vtkUnstructuredGrid* mesh, const std::vector<vtkIdType>& cells, int levels)
{
  vtkNew<vtkExtractCells> near;
  near->SetInputData(mesh);
  near->SetCellIds(cells.data(), static_cast<vtkIdType>(cells.size()));
  near->AssumeSortedAndUniqueIdsOn();
  near->Update();
  vtkNew<vtkGhostCellsGenerator> generator;
  generator->SetInputData(near->GetOutput());
  generator->SetNumberOfGhostLayers(levels);
  generator->BuildIfRequiredOff();
  generator->Update();
  return vtkUnstructuredGrid::SafeDownCast(generator->GetOutputDataObject(0));
}

vtkUnsignedCharArray* addGhostArray(vtkDataSetAttributes* attributes, vtkIdType size)
{
  vtkNew<vtkUnsignedCharArray> ghosts;
  ghosts->SetName(vtkDataSetAttributes::GhostArrayName());
  ghosts->SetNumberOfValues(size);
  ghosts->FillValue(0);
  attributes->AddArray(ghosts);
  return ghosts;
}

// Appends to the mesh what only `from` has.
class Appender
{
public:
  Appender(
    vtkUnstructuredGrid* mesh, vtkUnstructuredGrid* from, const std::vector<vtkIdType>& cells)
    : mesh_(mesh)
    , from_(from)
  {
    auto* ids = vtkIdTypeArray::SafeDownCast(mesh->GetPointData()->GetGlobalIds());
    for (const vtkIdType cell : cells)
    {
      vtkIdType count = 0;
      const vtkIdType* points = nullptr;
      mesh->GetCells()->GetCellAtId(cell, count, points);
      for (vtkIdType i = 0; i < count; ++i)
      {
        known_.emplace_back(ids->GetValue(points[i]), points[i]);
      }
    }
    std::sort(known_.begin(), known_.end());
    known_.erase(std::unique(known_.begin(), known_.end()), known_.end());
  }

  void run()
  {
    vtkUnsignedCharArray* cells = from_->GetCellGhostArray();
    vtkUnsignedCharArray* points = from_->GetPointGhostArray();
    addPoints();
    vtkUnsignedCharArray* pointGhosts =
      addGhostArray(mesh_->GetPointData(), mesh_->GetNumberOfPoints());
    for (vtkIdType p = 0; points && p < from_->GetNumberOfPoints(); ++p)
    {
      pointGhosts->SetValue(pointOf_[static_cast<std::size_t>(p)], points->GetValue(p));
    }
    const vtkIdType own = mesh_->GetNumberOfCells();
    for (vtkIdType c = 0; cells && c < from_->GetNumberOfCells(); ++c)
    {
      if (cells->GetValue(c) & vtkDataSetAttributes::DUPLICATECELL)
      {
        addCell(c);
        appendTuple(c, from_->GetCellData(), mesh_->GetCellData());
      }
    }
    vtkUnsignedCharArray* cellGhosts =
      addGhostArray(mesh_->GetCellData(), mesh_->GetNumberOfCells());
    std::fill(cellGhosts->GetPointer(0) + own,
      cellGhosts->GetPointer(0) + mesh_->GetNumberOfCells(),
      static_cast<unsigned char>(vtkDataSetAttributes::DUPLICATECELL));
  }

private:
  static void appendTuple(vtkIdType at, vtkDataSetAttributes* from, vtkDataSetAttributes* to)
  {
    for (int i = 0; i < to->GetNumberOfArrays(); ++i)
    {
      vtkAbstractArray* array = to->GetAbstractArray(i);
      array->InsertNextTuple(at, from->GetAbstractArray(array->GetName()));
    }
  }

  void addPoints()
  {
    auto* ids = vtkIdTypeArray::SafeDownCast(from_->GetPointData()->GetGlobalIds());
    pointOf_.resize(static_cast<std::size_t>(from_->GetNumberOfPoints()));
    for (vtkIdType p = 0; p < from_->GetNumberOfPoints(); ++p)
    {
      const auto id = std::make_pair(ids->GetValue(p), vtkIdType(0));
      const auto at = std::lower_bound(known_.begin(), known_.end(), id);
      vtkIdType& point = pointOf_[static_cast<std::size_t>(p)];
      if (at != known_.end() && at->first == id.first)
      {
        point = at->second;
        continue;
      }
      point = mesh_->GetPoints()->InsertNextPoint(from_->GetPoint(p));
      appendTuple(p, from_->GetPointData(), mesh_->GetPointData());
    }
  }

  void addCell(vtkIdType cell)
  {
    const auto rename = [&](vtkIdType i) {
      ids_->SetId(i, pointOf_[static_cast<std::size_t>(ids_->GetId(i))]);
    };
    if (from_->GetCellType(cell) != VTK_POLYHEDRON)
    {
      from_->GetCellPoints(cell, ids_);
      for (vtkIdType i = 0; i < ids_->GetNumberOfIds(); ++i)
      {
        rename(i);
      }
      mesh_->InsertNextCell(from_->GetCellType(cell), ids_);
      return;
    }
    from_->GetFaceStream(cell, ids_);
    for (vtkIdType face = 0, at = 1; face < ids_->GetId(0); ++face)
    {
      const vtkIdType end = at + 1 + ids_->GetId(at);
      for (++at; at < end; ++at)
      {
        rename(at);
      }
    }
    mesh_->InsertNextCell(VTK_POLYHEDRON, ids_);
  }

  vtkUnstructuredGrid* mesh_;
  vtkUnstructuredGrid* from_;
  std::vector<std::pair<vtkIdType, vtkIdType>> known_; // global ids of points near others, points
  std::vector<vtkIdType> pointOf_;                     // of each of from's
  vtkNew<vtkIdList> ids_;
};

}

void addGhostCells(vtkUnstructuredGrid* mesh, int levels, const Processes& processes)
{
  const std::vector<vtkIdType> cells = cellsNear(mesh, overlaps(mesh, processes), levels);
  Appender(mesh, withGhosts(mesh, cells, levels), cells).run();
}

}
