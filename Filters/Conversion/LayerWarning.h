// SPDX-License-Identifier: BSD-3-Clause
// The warning about missing boundary layers.
#pragma once

#include "Layers/BoundaryLayers.h"

#include <string>

class vtkDataObject;

namespace cartesian
{

// The boundaries whose walls have too few layers, or empty. `mesh`: as toVTK wrote it, with the coverage of each.
std::string describeBareWalls(const BoundaryLayers& layers, vtkDataObject* mesh);

}
