// SPDX-License-Identifier: BSD-3-Clause
#include "PolyhedronStorage.h"

#include "vtkCellArray.h"
#include "vtkIdList.h"
#include "vtkIdTypeArray.h"
#include "vtkNew.h"
#include "vtkUnsignedCharArray.h"
#include "vtkUnstructuredGrid.h"
#include "vtkVersionMacros.h"

namespace cartesian
{

#if VTK_VERSION_NUMBER >= VTK_VERSION_CHECK(9, 3, 20240112)

// From VTK 9.4 on there is one array of the faces of all cells, and a list of them for each cell. Never
// compiled so far: ParaView 5.11 has VTK 9.2.
void setCells(vtkUnstructuredGrid* grid, vtkUnsignedCharArray* types, vtkCellArray* cells,
  vtkIdTypeArray* faceStart, vtkIdTypeArray* faceStream)
{
  if (faceStream->GetNumberOfValues() == 0)
  {
    grid->SetCells(types, cells);
    return;
  }
  vtkNew<vtkCellArray> faces;
  vtkNew<vtkCellArray> facesOfCells;
  for (vtkIdType cell = 0; cell < faceStart->GetNumberOfValues(); ++cell)
  {
    const vtkIdType start = faceStart->GetValue(cell);
    const vtkIdType* stream = start < 0 ? nullptr : faceStream->GetPointer(start);
    const vtkIdType count = stream ? *stream++ : 0;
    facesOfCells->InsertNextCell(static_cast<int>(count));
    for (vtkIdType face = 0; face < count; ++face)
    {
      const vtkIdType size = *stream++;
      facesOfCells->InsertCellPoint(faces->InsertNextCell(size, stream));
      stream += size;
    }
  }
  grid->SetPolyhedralCells(types, cells, facesOfCells, faces);
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

const vtkIdType* faceStreamOf(vtkUnstructuredGrid* grid, vtkIdType cell, vtkIdList* /*scratch*/)
{
  return grid->GetFaces(cell); // as it is stored
}

#endif

}
