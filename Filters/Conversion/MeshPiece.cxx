// SPDX-License-Identifier: BSD-3-Clause
#include "MeshPiece.h"

#include "BoundaryOfFaces.h"
#include "Mesh/OutputMesh.h"

#include "vtkCellData.h"
#include "vtkFieldData.h"
#include "vtkIdTypeArray.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkPolyData.h"
#include "vtkUnstructuredGrid.h"

namespace cartesian
{

namespace
{

// Adds to the first component of each tuple.
void shift(vtkAbstractArray* array, Id by)
{
  auto* ids = vtkIdTypeArray::SafeDownCast(array);
  for (vtkIdType i = 0; i < ids->GetNumberOfTuples(); ++i)
  {
    ids->SetTypedComponent(i, 0, ids->GetTypedComponent(i, 0) + by);
  }
}

}

void setGlobalIds(const OutputMesh& kernel, const MeshPiece& piece, vtkUnstructuredGrid* mesh,
  vtkPolyData* boundary, Execution& execution)
{
  vtkNew<vtkIdTypeArray> points;
  points->SetName("GlobalPointIds");
  points->SetNumberOfValues(kernel.pointCount());
  kernel.writeGlobalPoints(piece.pointsBefore, points->GetPointer(0), execution);
  auto* meshPoint =
    vtkIdTypeArray::SafeDownCast(boundary->GetPointData()->GetAbstractArray("MeshPointId"));
  for (vtkIdType i = 0; i < meshPoint->GetNumberOfValues(); ++i)
  {
    meshPoint->SetValue(i, points->GetValue(meshPoint->GetValue(i)));
  }
  mesh->GetPointData()->SetGlobalIds(points);

  vtkAbstractArray* cells = mesh->GetCellData()->GetAbstractArray(CellId);
  shift(cells, piece.cellsBefore);
  shift(boundary->GetCellData()->GetAbstractArray("OwnerCell"), piece.cellsBefore);
  shift(mesh->GetFieldData()->GetAbstractArray(BoundaryOfFaces), piece.cellsBefore);
  mesh->GetCellData()->SetGlobalIds(vtkIdTypeArray::SafeDownCast(cells));
}

}
