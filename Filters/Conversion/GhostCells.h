// SPDX-License-Identifier: BSD-3-Clause
// Ghost cells of a mesh that several processes have a piece of each.
#pragma once

class vtkUnstructuredGrid;

namespace cartesian
{

class Processes;

// Adds `levels` layers of the other processes' cells, with the arrays vtkGhostType of cells and points
// (section "Ghost" of VTK's vtkDataSetAttributes). Pieces have global ids, and the same coordinates for
// points in common. All processes call it.
//
// The ghost cells are those of vtkGhostCellsGenerator. That filter looks through all the cells that it
// gets, so it gets those near other pieces only.
void addGhostCells(vtkUnstructuredGrid* mesh, int levels, const Processes& processes);

}
