// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>

namespace cartesian
{

// Why a cell is left out: counted by its reason (Mesher/Statistics), all are among the cells left out (Defects).
enum class RemovalReason : std::uint8_t
{
  Small,   // next to its box, and no neighbour can take it (section 4.10)
  Refused, // by solvers: it overlaps others, or has a face that fails their limits, and nothing else helps (4.11)
  Rim, // by solvers too: a piece of a cell around the rim of something thin (Editing/RefusalEnding)
  Fragment, // the grid cuts it off from the rest
};

// A cell of the core, or a part of one, that is left out.
struct RemovedCell
{
  std::uint32_t box;
  double volume; // in levels
  RemovalReason reason;
};

}
