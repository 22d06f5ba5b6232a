// SPDX-License-Identifier: BSD-3-Clause
// The wall, from raw cells to ones that solvers take: simplified, short edges snapped, then the loop, first in general, then
// for what still fails, and last the volume made true.
#pragma once

#include "Editing/EditMesh.h"

namespace cartesian
{

struct ImprovementSpec
{
  bool movesNodes = true;   // also for what faces and cells cost
  bool trueVolume = true;   // nodes rise until the mesh has the volume of the surface
  bool removesCells = true; // small ones, where nothing else helps
};

// Faces and cells are measured (EditMeasures.h).
void improveWall(EditMesh& mesh, const ImprovementSpec& spec, Execution& execution);

}
