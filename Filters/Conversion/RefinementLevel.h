// SPDX-License-Identifier: BSD-3-Clause
// The refinement level of cells as one number, which views colour at first: of the three of Level, a view shows the
// magnitude.
#pragma once

class vtkCellData;

namespace cartesian
{

// Adds the cell array RefinementLevel, the largest of the three of Level, as the active scalars if cells differ.
void setRefinementLevel(vtkCellData* data);

}
