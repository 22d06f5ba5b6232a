// SPDX-License-Identifier: BSD-3-Clause
// How large bodies in a flow are: what coefficients of forces refer to.
#pragma once

#include "OpenFoam/PolyMeshFiles.h"

namespace cartesian
{

// Of the patches with these names: how long they are along an axis, and the area of their shadow along it, to about 0.1 %
// (counted in squares of 1/2048 of its longer side). In units of the mesh; both 0 where they have no faces.
struct BodySize
{
  double length = 0;
  double frontalArea = 0;
};

BodySize sizeOfBodies(const FoamMesh& mesh, const std::vector<std::string>& names, int axis);

// The axis along which those patches are shortest, such as the normal of a side; none: they have no faces.
std::optional<int> flatAxisOf(const FoamMesh& mesh, const std::vector<std::string>& names);

}
