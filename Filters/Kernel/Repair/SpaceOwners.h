// SPDX-License-Identifier: BSD-3-Clause
// Which spaces are whose, where regions are open towards earlier ones (Contacts.h).
//
// A region's walls point out of its spaces. So those that no earlier region has are joined across the walls of others, and
// the area of its own walls around them tells, the more of it points one way. What is connected by nothing but space is
// found along lines.
#pragma once

#include "Repair/Spaces.h"
#include "Repair/WallsOfBodies.h"

namespace cartesian
{

// In Surface::region, where there are so many regions: beyond those of sheets (WallsOfBodies.h).
constexpr std::int32_t regionOfCurtains(std::int32_t region, std::int32_t regions)
{
  return regionOfSheets(regions + region, regions);
}

// The region that winds around each space, once. Contradictions: walls, not curtains, without a space of their own behind
// them, or with one in front, unless these are a few slivers.
Spaces findOwners(const Surface& arranged, const std::vector<Piece>& pieces, std::int32_t regions,
  Execution& execution);

}
