// SPDX-License-Identifier: BSD-3-Clause
// Improves the faces and cells that cost most, one by one: of the proposals for each, that which gains most, or enough,
// is made; then what it changed is looked at again.
//
// Method: a queue by cost, ties by number, so that the order is that of the mesh alone. Ends as each edit makes the sum of costs fall
// by a least part of an item. Limits: proposals come from the surroundings of one face or cell (Proposals.h), never from two at once: an
// edit that pays only together with another is found only where that follows by itself (ProposalTrials.h).
#pragma once

#include "Cells/RemovedCell.h"
#include "Editing/EditBlocks.h"
#include "Editing/ProposalTrials.h"

namespace cartesian
{

struct LoopSpec
{
  EditRules rules;
  SearchSpec search;
  double leastCost = 1.5;        // of what is looked at
  double leastGain = 0.05;       // of an item's cost, by an edit
  double leastGainOfMove = 0.15; // ... by a node that moves
  bool failingOnly = false;      // of that, faces that fail and cells without a third direction
};

// Of cells, and of what detail they show.
struct MadeEdit
{
  std::uint32_t boxIndex;                      // the box of the cell
  EditKind kind;                               // Merge, Remove, Cut or Flatten
  double removed = 0;                          // what the cell held, if it was removed, in levels
  RemovalReason reason = RemovalReason::Small; // ... and why

  bool operator<(const MadeEdit& other) const
  {
    return std::tie(boxIndex, kind, removed, reason) <
      std::tie(other.boxIndex, other.kind, other.removed, other.reason);
  }
};

// Of the cell that was kept, or is gone. Before the commit.
MadeEdit madeEdit(const MeshView& mesh, EditKind kind, std::uint32_t c);

// Whether a face of a cell failed the limits of solvers before the edits since the last commit, which removed the cell.
bool wasRefused(const MeshEditor& mesh, std::uint32_t c);

// Costs are of the same objective (costAll). `poll`: called now and then; may throw.
std::vector<MadeEdit> improve(
  const ZoneTask& task, const LoopSpec& spec, const std::function<void()>& poll);

}
