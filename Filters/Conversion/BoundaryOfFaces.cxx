// SPDX-License-Identifier: BSD-3-Clause
#include "BoundaryOfFaces.h"

#include "Base/Sorting.h"
#include "Cells/Cells.h"

#include "vtkCellArray.h"
#include "vtkCellArrayIterator.h"
#include "vtkCellData.h"
#include "vtkFieldData.h"
#include "vtkIdTypeArray.h"
#include "vtkIntArray.h"
#include "vtkPointData.h"
#include "vtkPolyData.h"
#include "vtkStringArray.h"
#include "vtkUnstructuredGrid.h"

#include <algorithm>
#include <array>
#include <atomic>

namespace cartesian
{

namespace
{

constexpr std::size_t ItemsAChunk = 1 << 16;
constexpr std::size_t FacesAChunk = 2048;

constexpr int CellOf = 0;
constexpr int FaceOf = 1;
constexpr int BoundaryOf = 2;

// Whether two faces have the same corners in the same cyclic order.
bool sameLoop(const std::vector<vtkIdType>& loop, const vtkIdType* points, vtkIdType count)
{
  if (static_cast<vtkIdType>(loop.size()) != count)
  {
    return false;
  }
  const vtkIdType shift = std::find(points, points + count, loop[0]) - points;
  for (vtkIdType i = 0; i < count; ++i)
  {
    if (shift == count || loop[static_cast<std::size_t>(i)] != points[(shift + i) % count])
    {
      return false;
    }
  }
  return true;
}

// The index of the face in the face stream of a cell, or the number of its faces if it is none of them.
vtkIdType findFace(const std::vector<vtkIdType>& face, const vtkIdType* stream)
{
  const vtkIdType count = *stream++;
  for (vtkIdType f = 0; f < count; ++f)
  {
    if (sameLoop(face, stream + 1, *stream))
    {
      return f;
    }
    stream += *stream + 1;
  }
  return count;
}

vtkIdTypeArray* cellIdsOf(vtkUnstructuredGrid* mesh)
{
  return vtkIdTypeArray::SafeDownCast(mesh->GetCellData()->GetAbstractArray(CellId));
}

// Where each cell is in the mesh, by its CellId.
std::vector<vtkIdType> placesOfCells(vtkUnstructuredGrid* mesh, Execution& execution)
{
  const vtkIdType* const id = cellIdsOf(mesh)->GetPointer(0);
  std::vector<vtkIdType> places(static_cast<std::size_t>(mesh->GetNumberOfCells()));
  execution.forEach(places.size(), ItemsAChunk, [&](std::size_t begin, std::size_t end) {
    for (std::size_t c = begin; c < end; ++c)
    {
      places[static_cast<std::size_t>(id[c])] = static_cast<vtkIdType>(c);
    }
  });
  return places;
}

// In the boundary's order.
std::vector<BoundaryFaceRow> listRows(
  vtkUnstructuredGrid* mesh, vtkPolyData* boundary, Execution& execution)
{
  auto* owner =
    vtkIdTypeArray::SafeDownCast(boundary->GetCellData()->GetAbstractArray("OwnerCell"));
  auto* number = vtkIntArray::SafeDownCast(boundary->GetCellData()->GetAbstractArray("BoundaryId"));
  auto* meshPoint =
    vtkIdTypeArray::SafeDownCast(boundary->GetPointData()->GetAbstractArray("MeshPointId"));
  vtkCellArray* const polygons = boundary->GetPolys();
  const std::vector<vtkIdType> places = placesOfCells(mesh, execution);
  std::vector<BoundaryFaceRow> rows(static_cast<std::size_t>(polygons->GetNumberOfCells()));
  execution.forEach(rows.size(), FacesAChunk, [&](std::size_t begin, std::size_t end) {
    CellFaceReader reader(mesh);
    std::vector<vtkIdType> corners;
    auto polygon = vtk::TakeSmartPointer(polygons->NewIterator());
    for (std::size_t r = begin; r < end; ++r)
    {
      const auto face = static_cast<vtkIdType>(r);
      vtkIdType count = 0;
      const vtkIdType* points = nullptr;
      polygon->GetCellAtId(face, count, points);
      corners.resize(static_cast<std::size_t>(count));
      std::transform(points, points + count, corners.begin(),
        [&](vtkIdType point) { return meshPoint->GetValue(point); });
      const vtkIdType cell = owner->GetValue(face);
      const vtkIdType* const faces = reader.read(places[static_cast<std::size_t>(cell)]);
      rows[r] = { cell, findFace(corners, faces), number->GetValue(face) };
    }
  });
  return rows;
}

// Sorts by face the rows of each cell, which come in order of cells.
void sortFacesOfCells(std::vector<BoundaryFaceRow>& rows)
{
  for (auto begin = rows.begin(); begin != rows.end();)
  {
    const auto end = std::find_if(begin, rows.end(),
      [&](const BoundaryFaceRow& row) { return row[CellOf] != (*begin)[CellOf]; });
    std::sort(begin, end);
    begin = end;
  }
}

vtkIdTypeArray* rowsOf(vtkUnstructuredGrid* grid)
{
  auto* rows =
    vtkIdTypeArray::SafeDownCast(grid->GetFieldData()->GetAbstractArray(BoundaryOfFaces));
  return rows && rows->GetNumberOfComponents() == 3 ? rows : nullptr;
}

// The rows of BoundaryOfFaces of a grid, and its cells' numbers there.
class Rows
{
public:
  Rows(vtkIdTypeArray* rows, vtkIdTypeArray* ids, const CellFaces& cells,
    const std::vector<vtkIdType>& cellOf)
    : rows_(rows->GetPointer(0))
    , count_(static_cast<std::size_t>(rows->GetNumberOfTuples()))
    , ids_(ids->GetPointer(0))
    , cells_(cells)
    , cellOf_(cellOf)
  {
  }

  std::size_t count() const { return count_; }

  // The row of a face of a cell, or count().
  std::size_t find(std::uint32_t cell, std::size_t face) const
  {
    const vtkIdType id = ids_[cellOf_[cell]];
    const auto ofCell = static_cast<vtkIdType>(face - cells_.firstFace[cell]);
    std::size_t low = 0;
    std::size_t high = count_;
    while (low < high)
    {
      const std::size_t middle = low + (high - low) / 2;
      const bool before =
        get(middle, CellOf) != id ? get(middle, CellOf) < id : get(middle, FaceOf) < ofCell;
      (before ? low : high) = before ? middle + 1 : middle;
    }
    return low < count_ && get(low, CellOf) == id && get(low, FaceOf) == ofCell ? low : count_;
  }

  vtkIdType get(std::size_t row, int component) const
  {
    return rows_[3 * row + static_cast<std::size_t>(component)];
  }

private:
  const vtkIdType* rows_;
  std::size_t count_;
  const vtkIdType* ids_;
  const CellFaces& cells_;
  const std::vector<vtkIdType>& cellOf_;
};

// Inner faces that have rows.
std::vector<std::size_t> facesOfBaffles(
  const FaceList& list, const Rows& rows, Execution& execution)
{
  const std::size_t inner = list.neighbour.size();
  std::vector<std::vector<std::size_t>> found(chunks(inner, FacesAChunk));
  execution.forEach(inner, FacesAChunk, [&](std::size_t begin, std::size_t end) {
    for (std::size_t i = begin; i < end; ++i)
    {
      if (rows.find(list.owner[i], list.face[i]) < rows.count())
      {
        found[begin / FacesAChunk].push_back(i);
      }
    }
  });
  return concatenated(found);
}

}

void setBoundaryOfFaces(vtkUnstructuredGrid* mesh, vtkPolyData* boundary, Execution& execution)
{
  std::vector<BoundaryFaceRow> rows = listRows(mesh, boundary, execution);
  sortFacesOfCells(rows);
  vtkNew<vtkIdTypeArray> array;
  array->SetName(BoundaryOfFaces);
  array->SetNumberOfComponents(3);
  array->SetComponentName(CellOf, "Cell");
  array->SetComponentName(FaceOf, "Face");
  array->SetComponentName(BoundaryOf, "BoundaryId");
  array->SetNumberOfTuples(static_cast<vtkIdType>(rows.size()));
  for (std::size_t r = 0; r < rows.size(); ++r)
  {
    array->SetTypedTuple(static_cast<vtkIdType>(r), rows[r].data());
  }
  mesh->GetFieldData()->AddArray(array);
}

BoundaryKnowledge readBoundaryOfFaces(vtkUnstructuredGrid* grid, const CellFaces& cells,
  const std::vector<vtkIdType>& cellOf, FaceList& list, std::vector<vtkIdType>& boundary,
  Execution& execution)
{
  boundary.assign(list.face.size() - list.neighbour.size(), UnknownBoundary);
  vtkIdTypeArray* ids = cellIdsOf(grid);
  vtkIdTypeArray* array = rowsOf(grid);
  if (!ids || !array)
  {
    return BoundaryKnowledge::Nothing;
  }
  const Rows rows(array, ids, cells, cellOf);
  const std::vector<std::size_t> baffles = facesOfBaffles(list, rows, execution);
  const bool fit = std::all_of(baffles.begin(), baffles.end(), [&](std::size_t i) {
    const std::size_t beyond = faceBeyond(cells, list.face[i], list.neighbour[i]);
    return rows.find(list.neighbour[i], beyond) < rows.count();
  });
  if (!fit)
  {
    return BoundaryKnowledge::Unfit;
  }
  openFaces(cells, baffles, list);
  const std::size_t inner = list.neighbour.size();
  const std::size_t outer = list.face.size() - inner;
  boundary.assign(outer, UnknownBoundary);
  std::vector<std::atomic<bool>> isFound(rows.count());
  std::atomic<bool> isAnyTwice{ false };
  execution.forEach(outer, FacesAChunk, [&](std::size_t begin, std::size_t end) {
    for (std::size_t i = begin; i < end; ++i)
    {
      const std::size_t row = rows.find(list.owner[inner + i], list.face[inner + i]);
      if (row == rows.count())
      {
        continue;
      }
      boundary[i] = rows.get(row, BoundaryOf);
      if (isFound[row].exchange(true, std::memory_order_relaxed))
      {
        isAnyTwice.store(true, std::memory_order_relaxed);
      }
    }
  });
  return isAnyTwice ? BoundaryKnowledge::Unfit : BoundaryKnowledge::All;
}

std::map<vtkIdType, std::string> readBoundaryTexts(vtkUnstructuredGrid* grid, const char* name)
{
  std::map<vtkIdType, std::string> result;
  auto* texts = vtkStringArray::SafeDownCast(grid->GetFieldData()->GetAbstractArray(name));
  vtkDataArray* ids = grid->GetFieldData()->GetArray("BoundaryIds");
  for (vtkIdType i = 0; texts && i < texts->GetNumberOfValues(); ++i)
  {
    if (!ids)
    {
      result[i] = texts->GetValue(i);
    }
    else if (i < ids->GetNumberOfTuples())
    {
      result[static_cast<vtkIdType>(ids->GetComponent(i, 0))] = texts->GetValue(i);
    }
  }
  return result;
}

}
