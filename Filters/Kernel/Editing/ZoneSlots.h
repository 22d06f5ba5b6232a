// SPDX-License-Identifier: BSD-3-Clause
// Numbers for what each zone may make, while no other does (EditMesh.h: FreeSlots).
#pragma once

#include "Editing/EditMesh.h"

namespace cartesian
{

// How many a zone gets.
struct SlotCounts
{
  std::size_t nodes;
  std::size_t faces;
  std::size_t cells;
};

// Of each zone; the mesh has room for all of them then.
std::vector<FreeSlots> giveSlots(
  EditMesh& mesh, const std::vector<SlotCounts>& counts, Execution& execution);

// What was not used.
void takeSlotsBack(EditMesh& mesh, const std::vector<FreeSlots>& slots);

}
