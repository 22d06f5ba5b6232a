// SPDX-License-Identifier: BSD-3-Clause
// Repairs small faces between two regions, where cells of one end slightly off those of the other.
//
// Such a face is skew for the cell that has it besides a large one. The two cannot be joined, as other cells are
// beyond them; but the edge between these can move to the other side of the small face.
#pragma once

#include "Shaping/CellUnion.h"

#include "Base/Execution.h"

namespace cartesian
{

// Around these cells, in order: if the sum of all costs (CellCost.h) falls, and no more faces fail.
void mendInterfaces(CellComplex& cells, const std::vector<CellKey>& keys, Execution& execution);

}
