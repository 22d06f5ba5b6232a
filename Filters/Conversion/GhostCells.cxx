// SPDX-License-Identifier: BSD-3-Clause
#include "GhostCells.h"

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

#include <algorithm>
#include <array>
#include <cstdint>
#include <unordered_map>

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

// Another process, and which of our points it has too.
struct Neighbour
{
  std::size_t process;
  std::vector<vtkIdType> points;
};

// In order of the processes.
std::vector<Neighbour> neighbours(vtkUnstructuredGrid* mesh, const Processes& processes)
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
  std::vector<Neighbour> found;
  std::vector<std::vector<double>> all = processes.gather(names);
  for (std::size_t process = 0; process < all.size(); ++process)
  {
    std::vector<double>& theirs = all[process];
    std::sort(theirs.begin(), theirs.end());
    Neighbour neighbour{ process, {} };
    for (std::size_t i = 0; process != processes.ownNumber() && i < candidates.size(); ++i)
    {
      if (std::binary_search(theirs.begin(), theirs.end(), names[i]))
      {
        neighbour.points.push_back(candidates[i]);
      }
    }
    if (!neighbour.points.empty())
    {
      found.push_back(std::move(neighbour));
    }
  }
  return found;
}

// The cells that are ghosts there: with one of these points, or in a later layer with a point of the layer before.
vtkSmartPointer<vtkUnstructuredGrid> ghostsOf(
  vtkUnstructuredGrid* mesh, const std::vector<vtkIdType>& points, int levels)
{
  std::vector<std::uint8_t> isNear(static_cast<std::size_t>(mesh->GetNumberOfPoints()));
  for (const vtkIdType point : points)
  {
    isNear[static_cast<std::size_t>(point)] = 1;
  }
  std::vector<vtkIdType> cells;
  for (int level = 0; level < levels; ++level)
  {
    cells.clear();
    const std::vector<std::uint8_t> before = isNear;
    for (vtkIdType c = 0; c < mesh->GetNumberOfCells(); ++c)
    {
      vtkIdType count = 0;
      const vtkIdType* corners = nullptr;
      mesh->GetCells()->GetCellAtId(c, count, corners);
      if (std::any_of(corners, corners + count,
            [&](vtkIdType p) { return before[static_cast<std::size_t>(p)] != 0; }))
      {
        cells.push_back(c);
        std::for_each(
          corners, corners + count, [&](vtkIdType p) { isNear[static_cast<std::size_t>(p)] = 1; });
      }
    }
  }
  vtkNew<vtkExtractCells> extract;
  extract->SetInputData(mesh);
  extract->SetCellIds(cells.data(), static_cast<vtkIdType>(cells.size()));
  extract->AssumeSortedAndUniqueIdsOn();
  extract->Update();
  extract->GetOutput()->GetFieldData()->Initialize(); // that of the piece
  return extract->GetOutput();
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

// Appends the points and cells of other pieces to the mesh.
class Appender
{
public:
  Appender(vtkUnstructuredGrid* mesh, const std::vector<Neighbour>& neighbours, std::size_t own)
    : mesh_(mesh)
  {
    auto* ids = vtkIdTypeArray::SafeDownCast(mesh->GetPointData()->GetGlobalIds());
    pointGhosts_ = addGhostArray(mesh->GetPointData(), mesh->GetNumberOfPoints());
    for (const Neighbour& neighbour : neighbours)
    {
      for (const vtkIdType point : neighbour.points)
      {
        known_.emplace(ids->GetValue(point), point);
        if (neighbour.process < own)
        {
          pointGhosts_->SetValue(point, vtkDataSetAttributes::DUPLICATEPOINT);
        }
      }
    }
  }

  void run(const std::vector<vtkSmartPointer<vtkUnstructuredGrid>>& ghosts)
  {
    std::vector<std::vector<vtkIdType>> pointsOf;
    pointsOf.reserve(ghosts.size());
    for (const auto& from : ghosts)
    {
      pointsOf.push_back(addPoints(from));
    }
    const vtkIdType own = mesh_->GetNumberOfCells();
    const auto addAll = [&](bool polyhedra) {
      for (std::size_t i = 0; i < ghosts.size(); ++i)
      {
        addCells(ghosts[i], pointsOf[i], polyhedra);
      }
    };
    addAll(false);
    const vtkIdType polyhedra = mesh_->GetNumberOfCells();
    addAll(true);
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
      if (vtkAbstractArray* values = from->GetAbstractArray(array->GetName()))
      {
        array->InsertNextTuple(at, values);
      }
    }
  }

  // Of each point there, that of the mesh.
  std::vector<vtkIdType> addPoints(vtkUnstructuredGrid* from)
  {
    auto* ids = vtkIdTypeArray::SafeDownCast(from->GetPointData()->GetGlobalIds());
    std::vector<vtkIdType> points;
    for (vtkIdType p = 0; p < from->GetNumberOfPoints(); ++p)
    {
      const auto [at, isNew] = known_.emplace(ids->GetValue(p), mesh_->GetNumberOfPoints());
      if (isNew)
      {
        mesh_->GetPoints()->InsertNextPoint(from->GetPoint(p));
        appendTuple(p, from->GetPointData(), mesh_->GetPointData());
        pointGhosts_->InsertNextValue(vtkDataSetAttributes::DUPLICATEPOINT);
      }
      points.push_back(at->second);
    }
    return points;
  }

  // Those that are polyhedra, or the others.
  void addCells(vtkUnstructuredGrid* from, const std::vector<vtkIdType>& points, bool polyhedra)
  {
    for (vtkIdType c = 0; c < from->GetNumberOfCells(); ++c)
    {
      if ((from->GetCellType(c) == VTK_POLYHEDRON) == polyhedra)
      {
        addCell(from, c, points);
        appendTuple(c, from->GetCellData(), mesh_->GetCellData());
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

  void addCell(vtkUnstructuredGrid* from, vtkIdType cell, const std::vector<vtkIdType>& points)
  {
    const auto rename = [&](vtkIdType i) {
      ids_->SetId(i, points[static_cast<std::size_t>(ids_->GetId(i))]);
    };
    if (from->GetCellType(cell) != VTK_POLYHEDRON)
    {
      from->GetCellPoints(cell, ids_);
      for (vtkIdType i = 0; i < ids_->GetNumberOfIds(); ++i)
      {
        rename(i);
      }
      mesh_->InsertNextCell(from->GetCellType(cell), ids_);
      return;
    }
    from->GetFaceStream(cell, ids_);
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
  vtkUnsignedCharArray* pointGhosts_;
  std::unordered_map<vtkIdType, vtkIdType> known_; // of global ids in several pieces, the point
  vtkNew<vtkIdList> ids_;
};

}

void addGhostCells(vtkUnstructuredGrid* mesh, int levels, const Processes& processes)
{
  const std::vector<Neighbour> others = neighbours(mesh, processes);
  std::vector<vtkSmartPointer<vtkUnstructuredGrid>> ghosts;
  ghosts.reserve(others.size());
  for (const Neighbour& other : others)
  {
    ghosts.push_back(processes.exchange(ghostsOf(mesh, other.points, levels), other.process));
  }
  Appender(mesh, others, processes.ownNumber()).run(ghosts);
}

}
