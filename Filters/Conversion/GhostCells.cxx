// SPDX-License-Identifier: BSD-3-Clause
#include "GhostCells.h"

#include "Base/Error.h"
#include "PolyhedronStorage.h"
#include "Processes.h"

#include "vtkBoundingBox.h"
#include "vtkCellArray.h"
#include "vtkCellData.h"
#include "vtkCellType.h"
#include "vtkExtractCells.h"
#include "vtkIdList.h"
#include "vtkIdTypeArray.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkPoints.h"
#include "vtkUnsignedCharArray.h"
#include "vtkUnstructuredGrid.h"
#if VTK_MODULE_ENABLE_VTK_FiltersParallelDIY2
#include "vtkGhostCellsGenerator.h"
#endif

#include <algorithm>
#include <array>

namespace cartesian
{

namespace
{

// The intersections of this piece's bounds with those of the other pieces.
std::vector<vtkBoundingBox> overlaps(vtkUnstructuredGrid* mesh, const Processes& processes)
{
  vtkBoundingBox mine; // invalid if there are no points
  if (mesh->GetNumberOfPoints() > 0)
  {
    mine.SetBounds(mesh->GetPoints()->GetBounds());
  }
  std::vector<double> bounds(6);
  mine.GetBounds(bounds.data());
  const std::vector<std::vector<double>> all = processes.gather(bounds);
  std::vector<vtkBoundingBox> found;
  for (std::size_t i = 0; i < all.size(); ++i)
  {
    vtkBoundingBox box(all[i].data());
    if (i != processes.ownNumber() && box.IsValid() && mine.IsValid() && box.IntersectBox(mine))
    {
      found.push_back(box);
    }
  }
  return found;
}

bool isIn(const vtkBoundingBox& box, const std::array<double, 3>& point)
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

// Finds out which points another piece has too.
std::vector<std::uint8_t> sharedPoints(vtkUnstructuredGrid* mesh, const Processes& processes)
{
  auto* ids = vtkIdTypeArray::SafeDownCast(mesh->GetPointData()->GetGlobalIds());
  const std::vector<vtkBoundingBox> boxes = overlaps(mesh, processes);
  std::vector<vtkIdType> candidates;
  std::vector<double> names; // global ids: whole numbers below 2^53
  for (vtkIdType p = 0; p < mesh->GetNumberOfPoints(); ++p)
  {
    std::array<double, 3> point{};
    mesh->GetPoint(p, point.data());
    if (std::any_of(
          boxes.begin(), boxes.end(), [&](const vtkBoundingBox& box) { return isIn(box, point); }))
    {
      candidates.push_back(p);
      names.push_back(static_cast<double>(ids->GetValue(p)));
    }
  }
  std::vector<double> others;
  const std::vector<std::vector<double>> all = processes.gather(names);
  for (std::size_t i = 0; i < all.size(); ++i)
  {
    if (i != processes.ownNumber())
    {
      others.insert(others.end(), all[i].begin(), all[i].end());
    }
  }
  std::sort(others.begin(), others.end());
  std::vector<std::uint8_t> isShared(static_cast<std::size_t>(mesh->GetNumberOfPoints()));
  for (std::size_t i = 0; i < candidates.size(); ++i)
  {
    isShared[static_cast<std::size_t>(candidates[i])] =
      std::binary_search(others.begin(), others.end(), names[i]) ? 1 : 0;
  }
  return isShared;
}

// The cells that may be ghosts elsewhere, or share a point with one.
std::vector<vtkIdType> cellsNear(vtkUnstructuredGrid* mesh, const Processes& processes, int levels)
{
  std::vector<std::uint8_t> isNear = sharedPoints(mesh, processes);
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

#if VTK_MODULE_ENABLE_VTK_FiltersParallelDIY2
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
#else
vtkSmartPointer<vtkUnstructuredGrid> withGhosts(
  vtkUnstructuredGrid*, const std::vector<vtkIdType>&, int)
{
  throw Error(Fault::BadParameter,
    "This VTK has no module FiltersParallelDIY2, which finds ghost cells: ask for none.");
}
#endif

vtkUnsignedCharArray* addGhostArray(vtkDataSetAttributes* attributes, vtkIdType size)
{
  vtkNew<vtkUnsignedCharArray> ghosts;
  ghosts->SetName(vtkDataSetAttributes::GhostArrayName());
  ghosts->SetNumberOfValues(size);
  ghosts->FillValue(0);
  attributes->AddArray(ghosts);
  return ghosts;
}

// Appends the points and cells that only `from` has to the mesh.
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
    addCells(cells, false);
    const vtkIdType polyhedra = mesh_->GetNumberOfCells();
    addCells(cells, true);
    vtkUnsignedCharArray* cellGhosts =
      addGhostArray(mesh_->GetCellData(), mesh_->GetNumberOfCells());
    std::fill(cellGhosts->GetPointer(0) + own,
      cellGhosts->GetPointer(0) + mesh_->GetNumberOfCells(),
      static_cast<unsigned char>(vtkDataSetAttributes::DUPLICATECELL));
    moveBeforePolyhedra(own, polyhedra);
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

  // The ghosts that are polyhedra, or the others.
  void addCells(vtkUnsignedCharArray* ghosts, bool arePolyhedra)
  {
    for (vtkIdType c = 0; ghosts && c < from_->GetNumberOfCells(); ++c)
    {
      if (ghosts->GetValue(c) & vtkDataSetAttributes::DUPLICATECELL &&
        (from_->GetCellType(c) == VTK_POLYHEDRON) == arePolyhedra)
      {
        addCell(c);
        appendTuple(c, from_->GetCellData(), mesh_->GetCellData());
      }
    }
  }

  // Hexahedra come first, as in all meshes (OutputMesh.h).
  void moveBeforePolyhedra(vtkIdType begin, vtkIdType end)
  {
    vtkIdType first = begin;
    while (first > 0 && mesh_->GetCellType(first - 1) == VTK_POLYHEDRON)
    {
      --first;
    }
    if (first == begin || begin == end)
    {
      return;
    }
    rotateCells(mesh_, first, begin, end);
    for (int i = 0; i < mesh_->GetCellData()->GetNumberOfArrays(); ++i)
    {
      rotateTuples(mesh_->GetCellData()->GetAbstractArray(i), first, begin, end);
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
  const std::vector<vtkIdType> cells = cellsNear(mesh, processes, levels);
  Appender(mesh, withGhosts(mesh, cells, levels), cells).run();
}

}
