// SPDX-License-Identifier: BSD-3-Clause
// Small faces between two regions, where cells of one end a bit beside those of the other.
//
// Such a face is skew for the cell that has it besides a large one. Both cannot be one, as other cells are beyond
// them; but the edge between these can move to the other side of the small face: what was the end of one is then
// that of the other.
#pragma once

#include "Shaping/CellUnion.h"

#include "Base/Execution.h"

namespace cartesian
{

// Around these cells, in order: where the sum of all costs (CellCost.h) falls, and no more faces are refused.
void mendInterfaces(CellComplex& cells, const std::vector<CellKey>& keys, Execution& execution);

}
