// SPDX-License-Identifier: BSD-3-Clause
// Unites the pieces of a mesh that several processes have.
#pragma once

#include "vtkSmartPointer.h"

#include <vector>

class vtkDataObject;
class vtkUnstructuredGrid;

namespace cartesian
{

// Takes the cells that are not ghosts, in order of their CellId if all pieces have that array. Points with the same
// coordinates, or the same global ids, are merged, in order of the ids. Thus the pieces of Cartesian Mesher become
// the mesh that one process would make, including the boundary of each face (BoundaryOfFaces.h). Pieces may be null,
// empty or not grids.
vtkSmartPointer<vtkUnstructuredGrid> unitePieces(
  const std::vector<vtkSmartPointer<vtkDataObject>>& pieces);

}
