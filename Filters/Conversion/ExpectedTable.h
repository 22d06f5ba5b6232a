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

// Appends four texts a row: the size of boxes, after an arrow for the requested one, boxes, cells and memory. The
// first row has the column titles.
void toVTK(const std::vector<ExpectedRow>& rows, vtkStringArray* table);

// Appends four texts a row: where boxes are refined, the level, and the corners of that zone. The first row has the
// column titles.
void toVTK(const FlowRefinement& flow, vtkStringArray* table);

// Appends three texts a row: thickness of the first layer, number of layers, their thickness together, in the surface's unit
// and in millimetres. The first row has the column titles.
void toVTK(const WallLayerSpec& layers, double total, double metresPerUnit, vtkStringArray* table);

// Along x, y and z.
std::string describeLengths(const std::array<double, 3>& lengths);

// Of a surface's longest side; with a question below a centimetre and above a kilometre.
std::string describeLength(double metres);

}
