// SPDX-License-Identifier: BSD-3-Clause
// How this version of VTK stores polyhedra; only this file and its source depend on that.
#pragma once

#include "vtkType.h"

class vtkAbstractArray;
class vtkCellArray;
class vtkIdList;
class vtkIdTypeArray;
class vtkUnsignedCharArray;
class vtkUnstructuredGrid;

namespace cartesian
{

// Sets the cells of `grid`. `faceStart`: where the faces of each cell begin in `faceStream`, or -1 if it is no
// polyhedron. There, the number of faces is followed by the size and points of each.
void setCells(vtkUnstructuredGrid* grid, vtkUnsignedCharArray* types, vtkCellArray* cells,
  vtkIdTypeArray* faceStart, vtkIdTypeArray* faceStream);

// Puts the cells from `middle` to `end` before those from `first` to `middle`, which are of other types; arrays of cell
// data stay as they are.
void rotateCells(vtkUnstructuredGrid* grid, vtkIdType first, vtkIdType middle, vtkIdType end);

// The same with the tuples of an array.
void rotateTuples(vtkAbstractArray* array, vtkIdType first, vtkIdType middle, vtkIdType end);

// The faces of a polyhedron: their number, then the size and points of each. Valid until `scratch` or the grid
// changes.
const vtkIdType* faceStreamOf(vtkUnstructuredGrid* grid, vtkIdType cell, vtkIdList* scratch);

}
