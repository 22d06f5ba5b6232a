// SPDX-License-Identifier: BSD-3-Clause
// A vtkUnstructuredGrid as the faces of its cells.
#pragma once

#include "Quality/FaceList.h"

#include "vtkCellArrayIterator.h"
#include "vtkGenericCell.h"
#include "vtkIdList.h"
#include "vtkNew.h"
#include "vtkSmartPointer.h"

class vtkUnstructuredGrid;

namespace cartesian
{

// x, y, z of each point, as doubles: the grid's own array, or a copy of it in `copy`; null: it has no points.
const double* coordinatesOf(vtkUnstructuredGrid* grid, std::vector<double>& copy);

// The faces of one cell after the other, in VTK's order.
class CellFaceReader
{
public:
  explicit CellFaceReader(vtkUnstructuredGrid* grid);

  // The number of faces, then for each its size and points; valid until the next call. Null if the
  // cell has no volume. Throws Error (BadMesh) if its edges are curved.
  const vtkIdType* read(vtkIdType cell);

private:
  const vtkIdType* readHexahedron(vtkIdType cell);
  const vtkIdType* readOther(vtkIdType cell);

  vtkUnstructuredGrid* grid_;
  vtkNew<vtkIdList> stream_;
  vtkSmartPointer<vtkCellArrayIterator> points_;
  vtkNew<vtkGenericCell> cell_;
};

// The faces of all cells, with the numbers that cells and points have in the grid. Cells without a volume
// have no faces. Throws Error (BadMesh): a cell with curved edges, too many points.
CellFaces facesOfCells(vtkUnstructuredGrid* grid, Execution& execution);

// Of some of them, in this order.
CellFaces facesOfCells(
  vtkUnstructuredGrid* grid, const std::vector<vtkIdType>& which, Execution& execution);

// The cells that have a volume and are not ghosts, in order of their CellId (BoundaryOfFaces.h) if they have one:
// neighbours then have close numbers, which solvers prefer and the grid's order, with hexahedra first, does not give.
// And the points that they use, renumbered in order.
struct GridFaces
{
  CellFaces cells;
  std::vector<double> points;     // three coordinates each
  std::vector<vtkIdType> cellOf;  // number of each cell in the grid
  std::vector<vtkIdType> pointOf; // the same of each point

  // Throws Error (BadMesh): a cell with curved edges, no cells, or too many.
  GridFaces(vtkUnstructuredGrid* grid, Execution& execution);

private:
  void readCells(vtkUnstructuredGrid* grid, Execution& execution);
  void readPoints(vtkUnstructuredGrid* grid, Execution& execution);
};

}
