// SPDX-License-Identifier: BSD-3-Clause
// Closed surfaces of simple shapes, around regions of refinement.
#pragma once

#include "vtkSmartPointer.h"

#include <array>
#include <string>

class vtkPolyData;

namespace cartesian
{

// The box with this low corner and these lengths, or the sphere (if they differ, the ellipsoid) or the cylinder along an
// axis that fills it: "box", "sphere", "cylinderX", "cylinderY", "cylinderZ", in any case. Throws Error: BadParameter.
vtkSmartPointer<vtkPolyData> shapeInBox(const std::string& shape,
  const std::array<double, 3>& position, const std::array<double, 3>& lengths);

}
