// SPDX-License-Identifier: BSD-3-Clause
// A piece cut out of a whole mesh, for what can only be made of the whole: layers, a budget of cells, connected parts.
#pragma once

#include "Boxes/Boxes.h"
#include "Processes.h"

class vtkPolyData;
class vtkUnstructuredGrid;

namespace cartesian
{

// The outputs of toVTK (MeshToVTK.h).
struct MeshOutputs
{
  vtkUnstructuredGrid* mesh;
  vtkPolyData* boundary;
  vtkPolyData* interfaces;
};

// Gives the cells whose GlobalBox is in a piece, the boundary's and interfaces' faces that they own, and global ids
// as setGlobalIds does. `pieces`: ranges of layers of global boxes. Of
// field data, what adds up over the pieces of one process is the whole mesh's in the first, and 0 in others; of
// several processes all have it.
void cutPiece(const MeshOutputs& whole, const std::vector<SlabRange>& pieces, std::size_t number,
  const Processes& processes, const MeshOutputs& piece);

}
