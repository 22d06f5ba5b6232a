// SPDX-License-Identifier: BSD-3-Clause
// How this version of VTK stores polyhedra: the only file that knows.
#pragma once

#include "vtkType.h"

class vtkCellArray;
class vtkIdList;
class vtkIdTypeArray;
class vtkUnsignedCharArray;
class vtkUnstructuredGrid;

namespace cartesian
{

// Gives `grid` its cells. `faceStart`: for each cell where its faces are in `faceStream`, -1 if it is
// no polyhedron; there are a number of faces, then for each its size and points.
void setCells(vtkUnstructuredGrid* grid, vtkUnsignedCharArray* types, vtkCellArray* cells,
  vtkIdTypeArray* faceStart, vtkIdTypeArray* faceStream);

// The faces of a polyhedron: their number, then for each its size and points. Valid until `scratch` or
// the grid change.
const vtkIdType* faceStreamOf(vtkUnstructuredGrid* grid, vtkIdType cell, vtkIdList* scratch);

}
