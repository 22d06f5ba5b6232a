// SPDX-License-Identifier: BSD-3-Clause
// Ghost cells of a mesh that is distributed over several processes.
#pragma once

class vtkUnstructuredGrid;

namespace cartesian
{

class Processes;

// Adds `levels` layers of the other processes' cells, with the arrays vtkGhostType of cells and points
// (section "Ghost" of VTK's vtkDataSetAttributes). Pieces have global ids, and the same coordinates for
// points in common. All processes must call it.
//
// The ghost cells are those of vtkGhostCellsGenerator. As that filter searches all its cells, it only gets
// those near other pieces.
void addGhostCells(vtkUnstructuredGrid* mesh, int levels, const Processes& processes);

}
