// SPDX-License-Identifier: BSD-3-Clause
// The wall, from raw cells to ones that solvers take: simplified, short edges snapped, then the loop, first in general, then
// for what still fails, and last the volume made true.
#pragma once

#include "Editing/EditLoop.h"

namespace cartesian
{

struct ImprovementSpec
{
  double collapseRatio = 0.1;
  double mergeRatio = 0.3;  // of its box: where a cell is small
  bool movesNodes = true;   // also for what faces and cells cost
  bool trueVolume = true;   // nodes rise until the mesh has the volume of the surface
  bool removesCells = true; // small ones, where nothing else helps
};

// Faces and cells are measured (EditMeasures.h). Returns what was done to cells, by boxes.
std::vector<MadeEdit> improveWall(
  EditMesh& mesh, const ImprovementSpec& spec, Execution& execution);

}
