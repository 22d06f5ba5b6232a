// SPDX-License-Identifier: BSD-3-Clause
// Boundary layers on a finished mesh of a displaced surface, up to the surface as it was.
//
// Where a solver would refuse them, or cells that they stand on, they become thinner or end.
// In each round the mesh near the wall is measured (QualityMeasures.h). The nodes of each face at fault have half
// as much of the layers as before, in the end none, at once if the fault is between two stacks: these cannot
// mend by being thinner. Neighbours then have at most half of the full thickness more.
#pragma once

#include "Lifting/PrismStacks.h"

namespace cartesian
{

struct ChangedCell
{
  Id place;              // among the mesh's cells as CellArrays has them
  double volumeByFormer; // its volume divided by that before
};

struct BoundaryLayers
{
  WallLayerSpec spec;
  double thickness = 0; // of all layers, as asked
  PrismStacks stacks;
  std::vector<ChangedCell> changed;  // cells whose nodes moved
  std::vector<std::uint32_t> faults; // displaced triangles where some are left, in order
};

// On a mesh of all of the displaced surface.
BoundaryLayers addLayers(
  const OutputMesh& mesh, const Lattice& lattice, const WallLift& lift, Execution& execution);

}
