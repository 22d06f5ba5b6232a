// SPDX-License-Identifier: BSD-3-Clause
// A mesh one cell deep (Sections/FlatCells.h), as VTK has it.
#pragma once

#include "Sections/FlatCells.h"

class vtkUnstructuredGrid;

namespace cartesian
{

// Fills an empty grid; vtkFlatMesh.h lists its arrays. Throws Error: as sweep(); BadMesh (as GridFaces, or cells were changed
// since the mesh was made).
void makeFlat(vtkUnstructuredGrid* grid, const SweepSpec& spec, vtkUnstructuredGrid* output,
  Execution& execution);

}
