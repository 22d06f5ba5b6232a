// SPDX-License-Identifier: BSD-3-Clause
#include "DividedGrid.h"

#include "Base/Error.h"
#include "Base/Sorting.h"
#include "FieldData.h"
#include "GridFaces.h"

#include "vtkCellArray.h"
#include "vtkCellData.h"
#include "vtkCellType.h"
#include "vtkFieldData.h"
#include "vtkIdTypeArray.h"
#include "vtkPointData.h"
#include "vtkPoints.h"
#include "vtkUnsignedCharArray.h"
#include "vtkUnstructuredGrid.h"

#include <algorithm>
#include <cstdio>

namespace cartesian
{

namespace
{

constexpr std::size_t CellsAChunk = 1024;

// VTK's own kinds of cells that its filters cut by tables.
bool isOwnKind(int type)
{
  return type == VTK_TETRA || type == VTK_HEXAHEDRON || type == VTK_VOXEL || type == VTK_WEDGE ||
    type == VTK_PYRAMID;
}

// The parts of a divided cell, one by one: their type, and corners in VTK's order.
template <class Visitor>
void forEachPart(const CellFaces& cells, const CellDivision& division, std::size_t cell,
  vtkIdType firstNew, Visitor&& visit)
{
  const vtkIdType centre = firstNew + static_cast<vtkIdType>(division.fans.count() + cell);
  for (std::size_t face = cells.firstFace[cell]; face < cells.firstFace[cell + 1]; ++face)
  {
    const std::uint32_t* const c = cells.corners.data() + cells.firstCorner[face];
    const std::size_t size = cells.firstCorner[face + 1] - cells.firstCorner[face];
    if (division.fans.fanOf[face] != NoPoint)
    {
      const vtkIdType fan = firstNew + division.fans.fanOf[face];
      for (std::size_t i = 0; i < size; ++i)
      {
        const std::array<vtkIdType, 4> part{ c[(i + 1) % size], c[i], fan, centre };
        visit(VTK_TETRA, part.data(), part.size());
      }
    }
    else if (size == 3)
    {
      const std::array<vtkIdType, 4> part{ c[2], c[1], c[0], centre };
      visit(VTK_TETRA, part.data(), part.size());
    }
    else
    {
      const std::array<vtkIdType, 5> part{ c[3], c[2], c[1], c[0], centre };
      visit(VTK_PYRAMID, part.data(), part.size());
    }
  }
}

}

DividedGrid::DividedGrid(vtkUnstructuredGrid* grid, Execution& execution)
  : grid_(grid)
  , points_(coordinatesOf(grid, copy_))
  , numberOf_(static_cast<std::size_t>(grid->GetNumberOfCells()), NoPoint)
{
  execution.stage("Cells to divide", 0, 0.3);
  findDivided(execution);
  faces_ = facesOfCells(grid, divided_, execution);
  turnOutward(faces_, points_, execution);
  execution.stage("Centres", 0.3, 0.6);
  division_ = divideCells(faces_, points_, execution);
  countParts(execution);
}

void DividedGrid::findDivided(Execution& execution)
{
  const std::size_t count = numberOf_.size();
  std::vector<std::uint8_t> divides(count);
  execution.forEach(count, CellsAChunk, [&](std::size_t begin, std::size_t end) {
    CellFaceReader reader(grid_);
    for (std::size_t cell = begin; cell < end; ++cell)
    {
      const int type = grid_->GetCellType(static_cast<vtkIdType>(cell));
      if (type == VTK_TETRA)
      {
        continue;
      }
      const vtkIdType* stream = isOwnKind(type) || type == VTK_POLYHEDRON
        ? reader.read(static_cast<vtkIdType>(cell))
        : nullptr;
      divides[cell] = type == VTK_POLYHEDRON;
      for (vtkIdType faces = stream && type != VTK_POLYHEDRON ? *stream++ : 0; faces > 0; --faces)
      {
        const vtkIdType size = *stream++;
        std::array<Vector, 4> corners;
        std::array<std::uint32_t, 4> ids{};
        for (vtkIdType i = 0; i < size; ++i)
        {
          const vtkIdType point = *stream++;
          ids[static_cast<std::size_t>(i)] = static_cast<std::uint32_t>(point);
          std::copy_n(points_ + 3 * point, 3, corners[static_cast<std::size_t>(i)].data());
        }
        divides[cell] = divides[cell] != 0 || (size == 4 && !staysWhole(corners, ids));
      }
    }
  });
  for (std::size_t cell = 0; cell < count; ++cell)
  {
    if (divides[cell] != 0)
    {
      numberOf_[cell] = static_cast<std::uint32_t>(divided_.size());
      divided_.push_back(static_cast<vtkIdType>(cell));
    }
  }
}

void DividedGrid::countParts(Execution& execution)
{
  const std::size_t count = numberOf_.size();
  firstPart_.assign(count + 1, 0);
  firstCorner_.assign(count + 1, 0);
  execution.forEach(count, CellsAChunk, [&](std::size_t begin, std::size_t end) {
    for (std::size_t cell = begin; cell < end; ++cell)
    {
      if (numberOf_[cell] == NoPoint)
      {
        firstPart_[cell] = 1;
        firstCorner_[cell] =
          static_cast<std::size_t>(grid_->GetCells()->GetCellSize(static_cast<vtkIdType>(cell)));
        continue;
      }
      forEachPart(faces_, division_, numberOf_[cell], 0,
        [&](int /*type*/, const vtkIdType* /*corners*/, std::size_t size) {
          ++firstPart_[cell];
          firstCorner_[cell] += size;
        });
    }
  });
  scan(firstPart_);
  scan(firstCorner_);
}

void DividedGrid::check(double bytes) const
{
  constexpr double GiB = 1024.0 * 1024 * 1024;
  const auto parts = static_cast<double>(firstPart_.back());
  double ofAPart = sizeof(vtkIdType) + 1 + sizeof(vtkIdType);
  for (int a = 0; a < grid_->GetCellData()->GetNumberOfArrays(); ++a)
  {
    vtkAbstractArray* array = grid_->GetCellData()->GetAbstractArray(a);
    ofAPart += array->GetNumberOfComponents() * std::max(1, array->GetDataTypeSize());
  }
  const double needed = parts * ofAPart +
    static_cast<double>(firstCorner_.back()) * sizeof(vtkIdType) +
    static_cast<double>(division_.fans.count() + division_.centres.size()) * sizeof(Vector);
  if (needed > bytes)
  {
    std::array<char, 300> text;
    std::snprintf(text.data(), text.size(),
      "The %zu cells to divide would become %.4g parts, which take about %.4g GiB, more than the "
      "Memory Limit of %.4g "
      "GiB: extract a part of the mesh first, or raise the limit.",
      divided_.size(), parts, needed / GiB, bytes / GiB);
    throw Error(Fault::TooManyBoxes, text.data());
  }
}

void DividedGrid::write(vtkUnstructuredGrid* output, Execution& execution)
{
  execution.stage("Parts of cells", 0.6, 1);
  writeCells(output, execution);
  execution.reach(0.5);
  writePoints(output);
  writePointData(output, execution);
  execution.reach(0.7);
  writeCellData(output, execution);
  writeFieldData(output);
}

void DividedGrid::writeCells(vtkUnstructuredGrid* output, Execution& execution) const
{
  const std::size_t parts = firstPart_.back();
  vtkNew<vtkUnsignedCharArray> types;
  types->SetNumberOfValues(static_cast<vtkIdType>(parts));
  vtkNew<vtkIdTypeArray> offsets;
  offsets->SetNumberOfValues(static_cast<vtkIdType>(parts) + 1);
  vtkNew<vtkIdTypeArray> connectivity;
  connectivity->SetNumberOfValues(static_cast<vtkIdType>(firstCorner_.back()));
  unsigned char* const type = types->GetPointer(0);
  vtkIdType* const offset = offsets->GetPointer(0);
  vtkIdType* const corner = connectivity->GetPointer(0);
  offset[parts] = static_cast<vtkIdType>(firstCorner_.back());
  const vtkIdType firstNew = grid_->GetNumberOfPoints();
  execution.nextLoop(0.5);
  execution.forEach(numberOf_.size(), CellsAChunk, [&](std::size_t begin, std::size_t end) {
    auto points = vtk::TakeSmartPointer(grid_->GetCells()->NewIterator());
    for (std::size_t cell = begin; cell < end; ++cell)
    {
      std::size_t part = firstPart_[cell];
      std::size_t at = firstCorner_[cell];
      const auto add = [&](int kind, const vtkIdType* corners, std::size_t size) {
        type[part] = static_cast<unsigned char>(kind);
        offset[part++] = static_cast<vtkIdType>(at);
        std::copy_n(corners, size, corner + at);
        at += size;
      };
      if (numberOf_[cell] != NoPoint)
      {
        forEachPart(faces_, division_, numberOf_[cell], firstNew, add);
        continue;
      }
      vtkIdType size = 0;
      const vtkIdType* corners = nullptr;
      points->GetCellAtId(static_cast<vtkIdType>(cell), size, corners);
      add(
        grid_->GetCellType(static_cast<vtkIdType>(cell)), corners, static_cast<std::size_t>(size));
    }
  });
  vtkNew<vtkCellArray> cells;
  cells->SetData(offsets, connectivity);
  output->SetCells(types, cells);
}

void DividedGrid::writePoints(vtkUnstructuredGrid* output) const
{
  const vtkIdType given = grid_->GetNumberOfPoints();
  vtkNew<vtkPoints> points;
  points->SetDataTypeToDouble();
  points->SetNumberOfPoints(
    given + static_cast<vtkIdType>(division_.fans.count() + division_.centres.size()));
  auto* to = static_cast<double*>(points->GetVoidPointer(0));
  std::copy_n(points_, 3 * given, to);
  to += 3 * given;
  for (const std::vector<Vector>* places : { &division_.fans.centres, &division_.centres })
  {
    for (const Vector& place : *places)
    {
      to = std::copy(place.begin(), place.end(), to);
    }
  }
  output->SetPoints(points);
}

void DividedGrid::writePointData(vtkUnstructuredGrid* output, Execution& execution) const
{
  vtkPointData* from = grid_->GetPointData();
  if (from->GetNumberOfArrays() == 0)
  {
    return;
  }
  const PointSums sums = sumsOf(division_, faces_, points_, execution);
  vtkPointData* to = output->GetPointData();
  const vtkIdType given = grid_->GetNumberOfPoints();
  to->InterpolateAllocate(from, output->GetNumberOfPoints());
  to->SetNumberOfTuples(output->GetNumberOfPoints());
  to->CopyData(from, 0, given, 0);
  vtkNew<vtkIdList> ids;
  for (std::size_t i = 0; i + 1 < sums.first.size(); ++i)
  {
    ids->Reset();
    for (std::size_t term = sums.first[i]; term < sums.first[i + 1]; ++term)
    {
      ids->InsertNextId(sums.point[term]);
    }
    to->InterpolatePoint(from, given + static_cast<vtkIdType>(i), ids,
      const_cast<double*>(sums.weight.data() + sums.first[i]));
  }
}

void DividedGrid::writeCellData(vtkUnstructuredGrid* output, Execution& execution) const
{
  vtkNew<vtkIdTypeArray> original;
  original->SetName("OriginalCellId");
  original->SetNumberOfValues(static_cast<vtkIdType>(firstPart_.back()));
  vtkIdType* const id = original->GetPointer(0);
  execution.forEach(numberOf_.size(), CellsAChunk, [&](std::size_t begin, std::size_t end) {
    for (std::size_t cell = begin; cell < end; ++cell)
    {
      std::fill(id + firstPart_[cell], id + firstPart_[cell + 1], static_cast<vtkIdType>(cell));
    }
  });
  vtkCellData* from = grid_->GetCellData();
  vtkCellData* to = output->GetCellData();
  vtkNew<vtkIdList> ids;
  ids->SetArray(id, original->GetNumberOfValues());
  for (int a = 0; a < from->GetNumberOfArrays(); ++a)
  {
    vtkAbstractArray* array = from->GetAbstractArray(a);
    auto copy = vtk::TakeSmartPointer(array->NewInstance());
    copy->SetName(array->GetName());
    copy->SetNumberOfComponents(array->GetNumberOfComponents());
    copy->CopyComponentNames(array);
    copy->SetNumberOfTuples(original->GetNumberOfValues());
    array->GetTuples(ids, copy);
    to->AddArray(copy);
  }
  ids->Release();
  to->AddArray(original);
}

void DividedGrid::writeFieldData(vtkUnstructuredGrid* output) const
{
  output->GetFieldData()->PassData(grid_->GetFieldData());
  vtkNew<vtkIdTypeArray> notStarShaped;
  notStarShaped->SetName("NotStarShapedCells");
  for (std::size_t i = 0; i < divided_.size(); ++i)
  {
    if (division_.inverts[i] != 0)
    {
      notStarShaped->InsertNextValue(divided_[i]);
    }
  }
  setField(output, "CellsDivided", { static_cast<double>(divided_.size()) });
  setField(output, "CellsMoved", { static_cast<double>(division_.moved) });
  setField(
    output, "CellsNotStarShaped", { static_cast<double>(notStarShaped->GetNumberOfValues()) });
  output->GetFieldData()->AddArray(notStarShaped);
}

}
