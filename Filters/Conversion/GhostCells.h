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
// The ghost cells are those of vtkGhostCellsGenerator. That filter compares all points of all outer faces; here,
// the global ids tell which are in common.
void addGhostCells(vtkUnstructuredGrid* mesh, int levels, const Processes& processes);

}
