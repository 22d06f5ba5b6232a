// SPDX-License-Identifier: BSD-3-Clause
// How large a mesh will be, as the panel shows it.
#pragma once

#include "Boxes/FlowRefinement.h"
#include "Mesher/ExpectedMesh.h"

#include <array>
#include <string>
#include <vector>

class vtkStringArray;

namespace cartesian
{

// Appends four texts a row: the size of boxes, after an arrow where it is asked for, boxes, cells and memory. The first
// row says what the columns are.
void toVTK(const std::vector<ExpectedRow>& rows, vtkStringArray* table);

// Appends four texts a row: where boxes are halved, how often, and the corners of that zone. The first row says what the
// columns are.
void toVTK(const FlowRefinement& flow, vtkStringArray* table);

// Along x, y and z.
std::string describeLengths(const std::array<double, 3>& lengths);

}
