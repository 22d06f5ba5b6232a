// SPDX-License-Identifier: BSD-3-Clause
// One mesh out of the pieces that several processes have.
#pragma once

#include "vtkSmartPointer.h"

#include <vector>

class vtkDataObject;
class vtkUnstructuredGrid;

namespace cartesian
{

// Cells that are no ghosts, in the order of their CellId where all pieces have it; points that have
// the same coordinates, or the same global ids, are one, in order of the ids. So pieces of
// Cartesian Mesher's become the mesh of one process, with what boundary each face is of
// (BoundaryOfFaces.h). Pieces may be null, or no grids, or empty.
vtkSmartPointer<vtkUnstructuredGrid> unitePieces(
  const std::vector<vtkSmartPointer<vtkDataObject>>& pieces);

}
