// SPDX-License-Identifier: BSD-3-Clause
// A piece of a mesh (Parts/Decomposition.h) among the others.
#pragma once

#include "Cells/Boundary.h"
#include "Processes.h"

class vtkPolyData;
class vtkUnstructuredGrid;

namespace cartesian
{

class OutputMesh;

// Where the numbers of a piece begin in the whole mesh, and with which processes its statistics add up.
struct MeshPiece
{
  Id cellsBefore = 0;
  Id pointsBefore = 0; // own points (OutputMesh.h)
  bool isWhole = true;
  Processes processes;
};

// Replaces the numbers of cells and points in the arrays of both outputs (MeshToVTK.h) by those of the whole
// mesh, and gives the mesh global ids: CellId for cells, GlobalPointIds for points.
void setGlobalIds(const OutputMesh& kernel, const MeshPiece& piece, vtkUnstructuredGrid* mesh,
  vtkPolyData* boundary, Execution& execution);

}
