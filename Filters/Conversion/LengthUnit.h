// SPDX-License-Identifier: BSD-3-Clause
// The unit of a surface's coordinates, in metres: what a filter is told, or what a CAD Reader wrote into the field data.
#pragma once

#include <array>
#include <cstddef>

class vtkDataObject;

namespace cartesian
{

// Field data of surfaces and meshes: the length of their unit in metres.
constexpr const char* MetresPerUnitField = "MetresPerUnit";

// Metre, centimetre, millimetre, inch and foot.
constexpr std::array<double, 5> MetresPerUnits{ 1, 0.01, 0.001, 0.0254, 0.3048 };

// What the data say, or the first block that says it; 1: none does.
double metresPerUnit(vtkDataObject* data);

}
