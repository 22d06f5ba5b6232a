// SPDX-License-Identifier: BSD-3-Clause
#include "GridFaces.h"

#include "Base/Error.h"
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

std::vector<vtkIdType> cellsInOrder(vtkUnstructuredGrid* grid)
{
  std::vector<vtkIdType> cells(static_cast<std::size_t>(grid->GetNumberOfCells()));
  std::iota(cells.begin(), cells.end(), vtkIdType(0));
  if (auto* ids = vtkIdTypeArray::SafeDownCast(grid->GetCellData()->GetAbstractArray(CellId)))
  {
    std::stable_sort(cells.begin(), cells.end(),
      [ids](vtkIdType a, vtkIdType b) { return ids->GetValue(a) < ids->GetValue(b); });
  }
  return cells;
}

constexpr std::size_t CellsAChunk = 1024;

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

void finish(CellFaces& cells)
{
  cells.firstFace.push_back(cells.firstCorner.size());
  cells.firstCorner.push_back(cells.corners.size());
}

// Of parts that are not finished, and are emptied.
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
  all.firstFace.resize(places.back().cell);
  all.firstCorner.resize(places.back().face);
  all.corners.resize(places.back().corner);
  execution.forEach(parts.size(), 1, [&](std::size_t i, std::size_t) {
    const CellFaces part = std::move(parts[i]);
    const Place& at = places[i];
    std::transform(part.firstFace.begin(), part.firstFace.end(), all.firstFace.data() + at.cell,
      [&](std::size_t face) { return face + at.face; });
    std::transform(part.firstCorner.begin(), part.firstCorner.end(),
      all.firstCorner.data() + at.face, [&](std::size_t corner) { return corner + at.corner; });
    std::copy(part.corners.begin(), part.corners.end(), all.corners.data() + at.corner);
  });
  finish(all);
  return all;
}

}

CellFaces facesOfCells(vtkUnstructuredGrid* grid)
{
  checkPoints(grid);
  CellFaces cells;
  CellFaceReader reader(grid);
  for (vtkIdType c = 0; c < grid->GetNumberOfCells(); ++c)
  {
    append(reader.read(c), cells);
  }
  finish(cells);
  return cells;
}

CellFaces facesOfCells(
  vtkUnstructuredGrid* grid, const std::vector<vtkIdType>& which, Execution& execution)
{
  checkPoints(grid);
  std::vector<CellFaces> parts(chunks(which.size(), CellsAChunk));
  execution.forEach(which.size(), CellsAChunk, [&](std::size_t begin, std::size_t end) {
    CellFaceReader reader(grid);
    for (std::size_t i = begin; i < end; ++i)
    {
      append(reader.read(which[i]), parts[begin / CellsAChunk]);
    }
  });
  return joined(parts, execution);
}

GridFaces::GridFaces(vtkUnstructuredGrid* grid)
{
  checkPoints(grid);
  if (grid->GetNumberOfCells() > 0) // else there may be no arrays, as where a filter has failed
  {
    readCells(grid);
  }
  if (cellOf.empty())
  {
    throw Error(
      Fault::BadMesh, "There are no cells with a volume to write: connect a volume mesh.");
  }
  readPoints(grid);
}

void GridFaces::readCells(vtkUnstructuredGrid* grid)
{
  constexpr unsigned char leftOut =
    vtkDataSetAttributes::DUPLICATECELL | vtkDataSetAttributes::HIDDENCELL;
  vtkUnsignedCharArray* ghosts = grid->GetCellGhostArray();
  CellFaceReader reader(grid);
  for (const vtkIdType c : cellsInOrder(grid))
  {
    const vtkIdType* stream =
      ghosts && (ghosts->GetValue(c) & leftOut) != 0 ? nullptr : reader.read(c);
    if (stream)
    {
      cellOf.push_back(c);
      append(stream, cells);
    }
  }
  finish(cells);
}

void GridFaces::readPoints(vtkUnstructuredGrid* grid)
{
  std::vector<std::uint32_t> number(static_cast<std::size_t>(grid->GetNumberOfPoints()));
  for (const std::uint32_t point : cells.corners)
  {
    number[point] = 1;
  }
  for (std::size_t p = 0; p < number.size(); ++p)
  {
    if (number[p] != 0)
    {
      number[p] = static_cast<std::uint32_t>(pointOf.size());
      pointOf.push_back(static_cast<vtkIdType>(p));
      points.resize(points.size() + 3);
      grid->GetPoint(static_cast<vtkIdType>(p), points.data() + points.size() - 3);
    }
  }
  for (std::uint32_t& point : cells.corners)
  {
    point = number[point];
  }
}

}
