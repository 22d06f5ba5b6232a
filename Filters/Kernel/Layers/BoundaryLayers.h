// SPDX-License-Identifier: BSD-3-Clause
// Boundary layers on a finished mesh: its wall nodes move inwards, the points near them follow (NodeMotion.h), and
// stacks of prisms fill the gap (PrismStacks.h).
//
// Where solvers would refuse a face or a cell that they accepted before, or one of the layers, these become thinner
// or end. In each round the mesh near the wall is measured (QualityMeasures.h). The nodes of each face at fault, or those
// nearest to it, have less of the layers than before, in the end none; at once if the fault is between two
// stacks, as these cannot mend by being thinner. With layers nowhere the mesh is what it was: so there is an end.
//
// Each region has its layers as if there were no other one: on its boundary, and on its side of interfaces. These stay
// as they are, their faces the same for both sides (SharedNodes.h).
#pragma once

#include "Layers/SharedNodes.h"

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
  PrismStacks stacks;
  LayeredBoundary boundary;
  std::vector<ChangedCell> changed; // cells whose points moved
  std::vector<PointCopy> copies;    // on interfaces
  std::vector<Id> numbers;          // of all cells (LayerNumbers.h)
};

// `surface`: the one that was meshed.
BoundaryLayers addLayers(
  const OutputMesh& mesh, const Surface& surface, const WallLayerSpec& spec, Execution& execution);

}
