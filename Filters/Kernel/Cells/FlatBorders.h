// SPDX-License-Identifier: BSD-3-Clause
// Where two boundaries meet in one plane, such as a vent in a floor, nothing but their border tells them apart.
#pragma once

#include "Cells/WallMesh.h"

namespace cartesian
{

// A cell below this part of its box's volume has no thickness: it is left out.
constexpr double LeastOfThick = 1e-9;

// Of a patch.
struct BoundaryAndNormal
{
  std::int32_t boundary;
  Vector normal;
};

// Whether two of these, of different boundaries, lie in one plane.
bool haveBorderInPlane(const std::vector<BoundaryAndNormal>& patches);

// Whether two patches of a cell, of different boundaries, lie in one plane.
bool hasBorderInPlane(const Nodes& nodes, const WallMesh& wall, std::size_t cell);

}
