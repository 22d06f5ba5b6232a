// SPDX-License-Identifier: BSD-3-Clause
#include "GridFaces.h"

#include "Base/Error.h"
#include "Base/Sorting.h"
#include "BoundaryOfFaces.h"
#include "PolyhedronStorage.h"

#include "vtkCellArray.h"
#include "vtkCellData.h"
#include "vtkCellType.h"
#include "vtkDataSetAttributes.h"
#include "vtkDoubleArray.h"
#include "vtkHexahedron.h"
#include "vtkIdTypeArray.h"
#include "vtkUnsignedCharArray.h"
#include "vtkUnstructuredGrid.h"

#include <algorithm>
#include <array>
#include <atomic>
#include <exception>
#include <limits>
#include <numeric>
#include <utility>

namespace cartesian
{

const double* coordinatesOf(vtkUnstructuredGrid* grid, std::vector<double>& copy)
{
  if (!grid->GetPoints())
  {
    return nullptr;
  }
  if (auto* doubles = vtkDoubleArray::SafeDownCast(grid->GetPoints()->GetData()))
  {
    return doubles->GetPointer(0);
  }
  copy.resize(3 * static_cast<std::size_t>(grid->GetNumberOfPoints()));
  for (vtkIdType p = 0; p < grid->GetNumberOfPoints(); ++p)
  {
    grid->GetPoint(p, copy.data() + 3 * p);
  }
  return copy.data();
}

CellFaceReader::CellFaceReader(vtkUnstructuredGrid* grid)
  : grid_(grid)
{
  // A grid of a filter that has failed has none.
  if (vtkCellArray* const cells = grid->GetCells())
  {
    points_.TakeReference(cells->NewIterator());
  }
}

const vtkIdType* CellFaceReader::read(vtkIdType cell)
{
  switch (grid_->GetCellType(cell))
  {
    case VTK_HEXAHEDRON:
      return readHexahedron(cell);
    case VTK_POLYHEDRON:
      return faceStreamOf(grid_, cell, stream_);
    default:
      return readOther(cell);
  }
}

const vtkIdType* CellFaceReader::readHexahedron(vtkIdType cell)
{
  vtkIdType count = 0;
  const vtkIdType* points = nullptr;
  points_->GetCellAtId(cell, count, points);
  stream_->Reset();
  stream_->InsertNextId(6);
  for (int face = 0; face < 6; ++face)
  {
    stream_->InsertNextId(4);
    for (int i = 0; i < 4; ++i)
    {
      stream_->InsertNextId(points[vtkHexahedron::GetFaceArray(face)[i]]);
    }
  }
  return stream_->GetPointer(0);
}

const vtkIdType* CellFaceReader::readOther(vtkIdType cell)
{
  grid_->GetCell(cell, cell_);
  if (cell_->GetCellDimension() < 3)
  {
    return nullptr;
  }
  if (!cell_->IsLinear())
  {
    throw Error(Fault::BadMesh,
      "Cell " + std::to_string(cell) + " has curved edges: apply Tessellate first.");
  }
  stream_->Reset();
  stream_->InsertNextId(cell_->GetNumberOfFaces());
  for (int f = 0; f < cell_->GetNumberOfFaces(); ++f)
  {
    vtkCell* face = cell_->GetFace(f);
    const bool crossed = face->GetCellType() == VTK_PIXEL;
    stream_->InsertNextId(face->GetNumberOfPoints());
    for (int i = 0; i < face->GetNumberOfPoints(); ++i)
    {
      stream_->InsertNextId(face->GetPointId(crossed && i > 1 ? 5 - i : i));
    }
  }
  return stream_->GetPointer(0);
}

namespace
{

void checkPoints(vtkUnstructuredGrid* grid)
{
  if (grid->GetNumberOfPoints() >= std::numeric_limits<std::uint32_t>::max())
  {
    throw Error(
      Fault::BadMesh, "The mesh has more points than can be numbered in 32 bits: make it coarser.");
  }
}

constexpr std::size_t CellsAChunk = 1024;
constexpr std::size_t PointsAChunk = 1 << 14;

// Appends a cell as CellFaceReader gives it; null: a cell without faces.
void append(const vtkIdType* stream, CellFaces& cells)
{
  cells.firstFace.push_back(cells.firstCorner.size());
  for (vtkIdType faces = stream ? *stream++ : 0; faces > 0; --faces)
  {
    cells.firstCorner.push_back(cells.corners.size());
    for (vtkIdType corners = *stream++; corners > 0; --corners)
    {
      cells.corners.push_back(static_cast<std::uint32_t>(*stream++));
    }
  }
}

// Of parts without their ends, which are emptied.
CellFaces joined(std::vector<CellFaces>& parts, Execution& execution)
{
  struct Place
  {
    std::size_t cell = 0;
    std::size_t face = 0;
    std::size_t corner = 0;
  };
  std::vector<Place> places{ {} };
  for (const CellFaces& part : parts)
  {
    const Place& last = places.back();
    places.push_back({ last.cell + part.firstFace.size(), last.face + part.firstCorner.size(),
      last.corner + part.corners.size() });
  }
  CellFaces all;
  all.firstFace.resize(places.back().cell + 1);
  all.firstCorner.resize(places.back().face + 1);
  all.corners.resize(places.back().corner);
  all.firstFace.back() = places.back().face;
  all.firstCorner.back() = places.back().corner;
  execution.forEach(parts.size(), 1, [&](std::size_t i, std::size_t) {
    const CellFaces part = std::move(parts[i]);
    const Place& at = places[i];
    std::transform(part.firstFace.begin(), part.firstFace.end(), all.firstFace.data() + at.cell,
      [&](std::size_t face) { return face + at.face; });
    std::transform(part.firstCorner.begin(), part.firstCorner.end(),
      all.firstCorner.data() + at.face, [&](std::size_t corner) { return corner + at.corner; });
    std::copy(part.corners.begin(), part.corners.end(), all.corners.data() + at.corner);
  });
  return all;
}

// Calls readCell(reader, i, part) for each of `count` cells. Of several errors, throws that of the first cell.
template <class ReadCell>
std::vector<CellFaces> readParts(
  vtkUnstructuredGrid* grid, std::size_t count, ReadCell&& readCell, Execution& execution)
{
  std::vector<CellFaces> parts(chunks(count, CellsAChunk));
  std::vector<std::exception_ptr> failures(parts.size());
  execution.forEach(count, CellsAChunk, [&](std::size_t begin, std::size_t end) {
    try
    {
      CellFaceReader reader(grid);
      for (std::size_t i = begin; i < end; ++i)
      {
        readCell(reader, i, parts[begin / CellsAChunk]);
      }
    }
    catch (const Error&)
    {
      failures[begin / CellsAChunk] = std::current_exception();
    }
  });
  for (const std::exception_ptr& failure : failures)
  {
    if (failure)
    {
      std::rethrow_exception(failure);
    }
  }
  return parts;
}

// By their CellId, if they have one.
std::vector<vtkIdType> cellsInOrder(vtkUnstructuredGrid* grid, Execution& execution)
{
  const auto count = static_cast<std::size_t>(grid->GetNumberOfCells());
  auto* ids = vtkIdTypeArray::SafeDownCast(grid->GetCellData()->GetAbstractArray(CellId));
  RawVector<std::array<vtkIdType, 2>> rows(count); // id and place
  execution.forEach(count, CellsAChunk, [&](std::size_t begin, std::size_t end) {
    for (std::size_t c = begin; c < end; ++c)
    {
      const auto place = static_cast<vtkIdType>(c);
      rows[c] = { ids ? ids->GetValue(place) : place, place };
    }
  });
  sortAll(rows, execution);
  std::vector<vtkIdType> cells(count);
  execution.forEach(count, CellsAChunk, [&](std::size_t begin, std::size_t end) {
    for (std::size_t c = begin; c < end; ++c)
    {
      cells[c] = rows[c][1];
    }
  });
  return cells;
}

// Of points, those that cells use, in order. `number` receives the place of each of these.
std::vector<vtkIdType> usedPoints(
  const CellFaces& cells, RawVector<std::uint32_t>& number, Execution& execution)
{
  std::vector<std::atomic<bool>> isUsed(number.size());
  execution.forEach(cells.corners.size(), PointsAChunk, [&](std::size_t begin, std::size_t end) {
    for (std::size_t i = begin; i < end; ++i)
    {
      isUsed[cells.corners[i]].store(true, std::memory_order_relaxed);
    }
  });
  std::vector<std::vector<vtkIdType>> parts(chunks(number.size(), PointsAChunk));
  execution.forEach(number.size(), PointsAChunk, [&](std::size_t begin, std::size_t end) {
    for (std::size_t p = begin; p < end; ++p)
    {
      if (isUsed[p].load(std::memory_order_relaxed))
      {
        parts[begin / PointsAChunk].push_back(static_cast<vtkIdType>(p));
      }
    }
  });
  std::vector<vtkIdType> used = concatenated(parts);
  execution.forEach(used.size(), PointsAChunk, [&](std::size_t begin, std::size_t end) {
    for (std::size_t i = begin; i < end; ++i)
    {
      number[static_cast<std::size_t>(used[i])] = static_cast<std::uint32_t>(i);
    }
  });
  return used;
}

}

CellFaces facesOfCells(
  vtkUnstructuredGrid* grid, const std::vector<vtkIdType>& which, Execution& execution)
{
  checkPoints(grid);
  std::vector<CellFaces> parts = readParts(
    grid, which.size(),
    [&](CellFaceReader& reader, std::size_t i, CellFaces& part) {
      append(reader.read(which[i]), part);
    },
    execution);
  return joined(parts, execution);
}

CellFaces facesOfCells(vtkUnstructuredGrid* grid, Execution& execution)
{
  std::vector<vtkIdType> all(static_cast<std::size_t>(grid->GetNumberOfCells()));
  std::iota(all.begin(), all.end(), vtkIdType(0));
  return facesOfCells(grid, all, execution);
}

GridFaces::GridFaces(vtkUnstructuredGrid* grid, Execution& execution)
{
  checkPoints(grid);
  if (grid->GetNumberOfCells() > 0) // else there may be no arrays, as where a filter has failed
  {
    readCells(grid, execution);
  }
  if (cellOf.empty())
  {
    throw Error(
      Fault::BadMesh, "There are no cells with a volume to write: connect a volume mesh.");
  }
  readPoints(grid, execution);
}

void GridFaces::readCells(vtkUnstructuredGrid* grid, Execution& execution)
{
  constexpr unsigned char leftOut =
    vtkDataSetAttributes::DUPLICATECELL | vtkDataSetAttributes::HIDDENCELL;
  vtkUnsignedCharArray* ghosts = grid->GetCellGhostArray();
  const std::vector<vtkIdType> all = cellsInOrder(grid, execution);
  std::vector<std::vector<vtkIdType>> kept(chunks(all.size(), CellsAChunk));
  std::vector<CellFaces> parts = readParts(
    grid, all.size(),
    [&](CellFaceReader& reader, std::size_t i, CellFaces& part) {
      const vtkIdType c = all[i];
      const vtkIdType* stream =
        ghosts && (ghosts->GetValue(c) & leftOut) != 0 ? nullptr : reader.read(c);
      if (stream)
      {
        kept[i / CellsAChunk].push_back(c);
        append(stream, part);
      }
    },
    execution);
  cellOf = concatenated(kept);
  cells = joined(parts, execution);
}

void GridFaces::readPoints(vtkUnstructuredGrid* grid, Execution& execution)
{
  RawVector<std::uint32_t> number(static_cast<std::size_t>(grid->GetNumberOfPoints()));
  pointOf = usedPoints(cells, number, execution);
  std::vector<double> copy;
  const double* const all = coordinatesOf(grid, copy);
  points.resize(3 * pointOf.size());
  execution.forEach(pointOf.size(), PointsAChunk, [&](std::size_t begin, std::size_t end) {
    for (std::size_t i = begin; i < end; ++i)
    {
      std::copy_n(all + 3 * pointOf[i], 3, points.data() + 3 * i);
    }
  });
  execution.forEach(cells.corners.size(), PointsAChunk, [&](std::size_t begin, std::size_t end) {
    for (std::size_t i = begin; i < end; ++i)
    {
      cells.corners[i] = number[cells.corners[i]];
    }
  });
}

}
