// SPDX-License-Identifier: BSD-3-Clause
// The spaces into which triangles of closed bodies that do not cross divide the whole space, and how bodies wind around them.
//
// Nothing winds around what is far away; across the triangles between, that follows for any other space (as libigl extracts
// cells and propagates winding numbers).
#pragma once

#include "Repair/JoinedSides.h"

namespace cartesian
{

struct Spaces
{
  std::vector<std::array<std::uint32_t, 2>>
    beside; // of each piece: the space behind it, and in front
  std::vector<std::vector<std::int32_t>>
    turns; // of each space: how often each body winds around it, from 0 on
  std::vector<std::uint32_t>
    contradictions; // pieces across which bodies wind otherwise than they ought to: some cross
};

// Bodies are numbered from 1 to `bodies`, and closed.
Spaces findSpaces(const Surface& surface, const std::vector<Piece>& pieces, std::int32_t bodies,
  Execution& execution);

}
