// SPDX-License-Identifier: BSD-3-Clause
// The warnings about missing boundary layers, and about jumps beside them.
#pragma once

#include "Layers/BoundaryLayers.h"

#include <string>

class vtkDataObject;

namespace cartesian
{

// The boundaries whose walls have too few layers, or empty. `mesh`: as toVTK wrote it, with the coverage of each.
std::string describeBareWalls(const BoundaryLayers& layers, vtkDataObject* mesh);

// The boundaries beside whose last layers the cells are far larger, and how many layers would do; or empty.
std::string describeJumps(const BoundaryLayers& layers, vtkDataObject* mesh);

}
