// SPDX-License-Identifier: BSD-3-Clause
// Some cells of a grid, with all of its arrays.
#pragma once

#include <vector>

class vtkUnstructuredGrid;

namespace cartesian
{

// `isChosen`: of each cell, 0 or 1. Field data stay.
void selectCells(vtkUnstructuredGrid* grid, const std::vector<unsigned char>& isChosen,
  vtkUnstructuredGrid* output);

}
