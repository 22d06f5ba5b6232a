// SPDX-License-Identifier: BSD-3-Clause
// The faces of VTK's cells, for the kernel.
#pragma once

#include "FaceList.h"

class vtkUnstructuredGrid;

namespace cartesian
{

// Cells of less than three dimensions have no faces. Polyhedra must have outward faces, as VTK 9.7
// and later demand. Throws Error (BadParameter) for cells with curved edges.
CellFaces cellFacesFromVTK(vtkUnstructuredGrid* grid);

// x, y, z of each point, as doubles: the grid's own array, or a copy of it in `copy`.
const double* coordinates(vtkUnstructuredGrid* grid, std::vector<double>& copy);

}
