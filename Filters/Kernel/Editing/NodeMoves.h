// SPDX-License-Identifier: BSD-3-Clause
// Moves of nodes that might help: against the gradient of the objective, as far as their kind allows.
#pragma once

#include "Editing/ProposalTrials.h"

namespace cartesian
{

// Of these nodes, that with the most to gain first; with it what it gains, if that is more than `least`, else NoGain.
// `edge`: the length of a box's edge there.
double bestMove(MeshEditor& mesh, ProposalTrials& trials, const ObjectiveSpec& spec,
  const SearchSpec& search, const FixedList<std::uint32_t, 16>& nodes, double edge, double least,
  Proposal& best);

}
