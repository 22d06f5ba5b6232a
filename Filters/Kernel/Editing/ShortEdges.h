// SPDX-License-Identifier: BSD-3-Clause
// Short edges at the wall collapse, the shortest first (section 6, A3): of their ends, that of the higher kind stays.
#pragma once

#include "Editing/EditLoop.h"

namespace cartesian
{

// Those shorter than a part of a box's edge go wherever the mesh stays one. Of rules, only mayChangeWalls counts; costs are
// not looked at. Cells that changed are appended to `changed`.
void collapseShortEdges(const ZoneTask& task, const EditRules& rules, double length,
  const std::function<void()>& poll, std::vector<std::uint32_t>& changed);

// The same in cells with very many faces, of a surface with more detail than their boxes can show: longer edges each time,
// until fewer faces are left.
void thinCrowdedCells(
  const ZoneTask& task, const std::function<void()>& poll, std::vector<std::uint32_t>& changed);

struct SnapSpec
{
  double length = 0.3; // in boxes
  double slack = 0.3;  // how much costs may rise by one edge
};

// Those go that the rules allow. Costs are valid before and afterwards.
void snapEdges(const ZoneTask& task, const EditRules& rules, const SnapSpec& spec,
  const std::function<void()>& poll);

}
