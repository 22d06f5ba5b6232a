// SPDX-License-Identifier: BSD-3-Clause
// Removing a failing cell would leave a step in the wall, or a hole between two regions: if nothing else repairs it, it
// is cut into parts that may be poor, but are valid.
#pragma once

#include "Base/Execution.h"
#include "Shaping/CellComplex.h"

namespace cartesian
{

// Of these, in order, and of their parts: by the cut that leaves the fewest faces invalid (CellFaults::invalid), those
// of cells of other regions included; else by one that leaves as many, to make room for the next. Returns how many
// cuts there were.
std::size_t splitInvalid(CellComplex& cells, std::vector<CellKey> keys, Execution& execution);

}
