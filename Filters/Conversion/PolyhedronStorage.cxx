// SPDX-License-Identifier: BSD-3-Clause
#include "PolyhedronStorage.h"

#include "vtkCellArray.h"
#include "vtkIdList.h"
#include "vtkIdTypeArray.h"
#include "vtkNew.h"
#include "vtkSmartPointer.h"
#include "vtkUnsignedCharArray.h"
#include "vtkUnstructuredGrid.h"
#include "vtkVersionMacros.h"

#include <algorithm>
#include <numeric>
#include <vector>

namespace cartesian
{

namespace
{

// Of a grid with cells of several types.
vtkDataArray* typesOf(vtkUnstructuredGrid* grid)
{
#if VTK_VERSION_NUMBER >= VTK_VERSION_CHECK(9, 6, 0)
  return grid->GetCellTypes();
#else
  return grid->GetCellTypesArray();
#endif
}

// Of a cell array, each cell with its points.
void rotateLists(vtkCellArray* lists, vtkIdType first, vtkIdType middle, vtkIdType end)
{
  std::vector<vtkIdType> offset(static_cast<std::size_t>(end - first) + 1);
  for (vtkIdType cell = first; cell <= end; ++cell)
  {
    offset[static_cast<std::size_t>(cell - first)] =
      static_cast<vtkIdType>(lists->GetOffsetsArray()->GetComponent(cell, 0));
  }
  const vtkIdType before = offset[static_cast<std::size_t>(middle - first)];
  rotateTuples(lists->GetConnectivityArray(), offset.front(), before, offset.back());
  vtkIdType next = first;
  const auto place = [&](vtkIdType cell, vtkIdType shift) {
    lists->GetOffsetsArray()->SetComponent(
      next++, 0, static_cast<double>(offset[static_cast<std::size_t>(cell - first)] + shift));
  };
  for (vtkIdType cell = middle; cell < end; ++cell)
  {
    place(cell, offset.front() - before);
  }
  for (vtkIdType cell = first; cell < middle; ++cell)
  {
    place(cell, offset.back() - before);
  }
}

}

void rotateTuples(vtkAbstractArray* array, vtkIdType first, vtkIdType middle, vtkIdType end)
{
  const auto copy = vtk::TakeSmartPointer(array->NewInstance());
  copy->SetNumberOfComponents(array->GetNumberOfComponents());
  copy->SetNumberOfTuples(end - first);
  copy->InsertTuples(0, end - first, first, array);
  array->InsertTuples(first, end - middle, middle - first, copy);
  array->InsertTuples(first + end - middle, middle - first, 0, copy);
}

#if VTK_VERSION_NUMBER >= VTK_VERSION_CHECK(9, 3, 20240112)

// From VTK 9.4 on there is one array of the faces of all cells, and a list of them for each cell: here those
// numbered from firstFace[cell] to firstFace[cell + 1].
void setCells(vtkUnstructuredGrid* grid, vtkUnsignedCharArray* types, vtkCellArray* cells,
  vtkIdTypeArray* faceStart, vtkIdTypeArray* faceStream)
{
  if (faceStream->GetNumberOfValues() == 0)
  {
    grid->SetCells(types, cells);
    return;
  }
  const vtkIdType cellCount = faceStart->GetNumberOfValues();
  vtkNew<vtkIdTypeArray> firstFace;
  firstFace->SetNumberOfValues(cellCount + 1);
  vtkIdType faceCount = 0;
  vtkIdType polyhedra = 0;
  for (vtkIdType cell = 0; cell < cellCount; ++cell)
  {
    firstFace->SetValue(cell, faceCount);
    const vtkIdType start = faceStart->GetValue(cell);
    faceCount += start < 0 ? 0 : faceStream->GetValue(start);
    polyhedra += start < 0 ? 0 : 1;
  }
  firstFace->SetValue(cellCount, faceCount);

  vtkNew<vtkIdTypeArray> faceOffset;
  vtkNew<vtkIdTypeArray> corners;
  faceOffset->SetNumberOfValues(faceCount + 1);
  corners->SetNumberOfValues(faceStream->GetNumberOfValues() - polyhedra - faceCount);
  vtkIdType* offset = faceOffset->GetPointer(0);
  vtkIdType* corner = corners->GetPointer(0);
  *offset = 0;
  for (vtkIdType cell = 0; cell < cellCount; ++cell)
  {
    const vtkIdType start = faceStart->GetValue(cell);
    const vtkIdType* face = start < 0 ? nullptr : faceStream->GetPointer(start + 1);
    for (vtkIdType i = firstFace->GetValue(cell); i < firstFace->GetValue(cell + 1); ++i)
    {
      const vtkIdType size = *face++;
      offset[1] = offset[0] + size;
      ++offset;
      corner = std::copy_n(face, size, corner);
      face += size;
    }
  }
  vtkNew<vtkIdTypeArray> faceNumbers;
  faceNumbers->SetNumberOfValues(faceCount);
  std::iota(faceNumbers->GetPointer(0), faceNumbers->GetPointer(0) + faceCount, vtkIdType(0));

  vtkNew<vtkCellArray> faces;
  vtkNew<vtkCellArray> facesOfCells;
  faces->SetData(faceOffset, corners);
  facesOfCells->SetData(firstFace, faceNumbers);
  grid->SetPolyhedralCells(types, cells, facesOfCells, faces);
}

void rotateCells(vtkUnstructuredGrid* grid, vtkIdType first, vtkIdType middle, vtkIdType end)
{
  rotateTuples(typesOf(grid), first, middle, end);
  rotateLists(grid->GetCells(), first, middle, end);
  if (grid->GetPolyhedronFaceLocations())
  {
    rotateLists(grid->GetPolyhedronFaceLocations(), first, middle, end);
  }
}

const vtkIdType* faceStreamOf(vtkUnstructuredGrid* grid, vtkIdType cell, vtkIdList* scratch)
{
  grid->GetFaceStream(cell, scratch);
  return scratch->GetPointer(0);
}

#else

void setCells(vtkUnstructuredGrid* grid, vtkUnsignedCharArray* types, vtkCellArray* cells,
  vtkIdTypeArray* faceStart, vtkIdTypeArray* faceStream)
{
  const bool polyhedra = faceStream->GetNumberOfValues() > 0;
  grid->SetCells(types, cells, polyhedra ? faceStart : nullptr, polyhedra ? faceStream : nullptr);
}

void rotateCells(vtkUnstructuredGrid* grid, vtkIdType first, vtkIdType middle, vtkIdType end)
{
  rotateTuples(typesOf(grid), first, middle, end);
  rotateLists(grid->GetCells(), first, middle, end);
  if (grid->GetFaceLocations())
  {
    rotateTuples(grid->GetFaceLocations(), first, middle, end);
  }
}

const vtkIdType* faceStreamOf(vtkUnstructuredGrid* grid, vtkIdType cell, vtkIdList* /*scratch*/)
{
  return grid->GetFaces(cell); // as it is stored
}

#endif

}
