// SPDX-License-Identifier: BSD-3-Clause
// Cells at the wall that still are much too small become part of a neighbour, whatever that costs, or go (section 4.10).
#pragma once

#include "Editing/EditLoop.h"

namespace cartesian
{

// By EditMesh::small.
bool isSmallCell(const MeshView& mesh, std::uint32_t c);

// All small ones. `removes`: those that no neighbour can take. Costs are valid before and afterwards. Appends what was
// done.
void mergeOrRemoveSmallCells(
  const ZoneTask& task, const EditRules& rules, bool removes, std::vector<MadeEdit>& edits);

}
