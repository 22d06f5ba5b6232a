// SPDX-License-Identifier: BSD-3-Clause
// Possible edits of a poor face besides moving its nodes.
#pragma once

#include "Optimisation/Mending.h"

namespace cartesian
{

struct ProposedEdit
{
  enum class Kind
  {
    Collapse, // of node `one` into `other`
    Join      // of face `other` with `one`, where the union remains
  };
  Kind kind;
  std::uint32_t one;
  std::uint32_t other;
};

// Merging of close nodes, and of faces of one cell towards the same neighbour or in the same boundary. In an order
// that follows from that of the face's corners and of its cell's faces.
void proposeEdits(const Mending& mending, std::uint32_t face, std::vector<ProposedEdit>& edits);

}
