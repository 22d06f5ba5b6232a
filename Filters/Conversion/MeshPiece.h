// SPDX-License-Identifier: BSD-3-Clause
// A piece of a mesh (Kernel/Decomposition.h) among the others.
#pragma once

#include "Cells/Boundary.h"
#include "Processes.h"

class vtkPolyData;
class vtkUnstructuredGrid;

namespace cartesian
{

class Mesh;

// Where a piece's numbers begin in the whole mesh, and with whom its statistics are added up.
struct MeshPiece
{
  Id cellsBefore = 0;
  Id pointsBefore = 0; // own points (Mesh.h)
  bool isWhole = true;
  Processes processes;
};

// Turns the numbers of cells and points that arrays of both outputs hold (MeshToVTK.h) into those of
// the whole mesh, and gives the mesh global ids: of cells CellId, of points GlobalPointIds.
void setGlobalIds(const Mesh& kernel, const MeshPiece& piece, vtkUnstructuredGrid* mesh,
  vtkPolyData* boundary, Execution& execution);

}
