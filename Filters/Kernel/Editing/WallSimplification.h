// SPDX-License-Identifier: BSD-3-Clause
// Geometric only, before quality is looked at: edges of next to no length go, walls of a cell that are nearly in one plane
// become one, nodes between two edges go, where the wall moves less than a tolerance, all that happens to it together.
#pragma once

#include "Editing/EditBlocks.h"
#include "Editing/EditDecision.h"

namespace cartesian
{

struct SimplificationSpec
{
  double weld = 0.01;      // in boxes: shorter edges have their ends made one
  double tolerance = 0.04; // in boxes: how far the wall may move
  double ofEdges = 0.002;  // ... at a sharp edge or border: there areas of flat walls depend on it
};

// Costs are valid before and afterwards. Where walls may not change, those in one plane become one.
void simplifyWalls(const ZoneTask& task, const SimplificationSpec& spec, const EditRules& rules,
  const std::function<void()>& poll);

}
