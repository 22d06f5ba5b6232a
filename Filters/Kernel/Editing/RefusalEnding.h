// SPDX-License-Identifier: BSD-3-Clause
// The last step: cells that solvers reject (Refusals.h) are taken apart until no piece is refused, whatever that gains; the
// smallest pieces that still are go. It ends: what goes changes no other cell.
#pragma once

#include "Editing/EditLoop.h"

namespace cartesian
{

// What went already: near it, little more may.
struct RemovedPiece
{
  Vector at;
  double boxes; // its volume, in boxes

  bool operator<(const RemovedPiece& other) const
  {
    return std::tie(at, boxes) < std::tie(other.at, other.boxes);
  }
};

// Looks at the refused cells of a task, each with what it becomes, by the kinds of edits that the rules allow. `removes`: what
// still is refused may go. `removed`: what went in all tasks before; what goes is added. `poll`: called now and then; may throw.
void endRefusals(const ZoneTask& task, const EditRules& rules, bool removes,
  std::vector<RemovedPiece>& removed, std::vector<MadeEdit>& edits,
  const std::function<void()>& poll);

}
