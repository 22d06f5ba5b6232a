// SPDX-License-Identifier: BSD-3-Clause
// Pairs of periodic boundaries, kept in the mesh (vtkPeriodicBoundaries.h), for those that write it.
#pragma once

#include "Sections/SideMotion.h"

#include <string>
#include <vector>

class vtkUnstructuredGrid;

namespace cartesian
{

// Field data array PeriodicPairs (double, 12 components): the numbers of both boundaries; then how the first comes to lie on the
// second: translation, axis and a point on it, angle in degrees. Their types (BoundaryTypes) are cyclic or cyclicAMI.
constexpr const char* PeriodicPairs = "PeriodicPairs";

struct PeriodicPair
{
  std::array<long long, 2> boundary;
  SideMotion motion;
};

// Of no grid: none.
std::vector<PeriodicPair> readPeriodicPairs(vtkUnstructuredGrid* grid);
void addPeriodicPair(const PeriodicPair& pair, vtkUnstructuredGrid* grid);

}
