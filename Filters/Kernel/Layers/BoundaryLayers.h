// SPDX-License-Identifier: BSD-3-Clause
// Boundary layers on a finished mesh: its wall nodes move inwards, the points near them follow (NodeMotion.h), and
// stacks of prisms fill the gap (PrismStacks.h).
//
// Where a face or a cell fails that passed before, or one of the layers does, these become thinner or end. In each
// round the mesh near the wall is measured (QualityMeasures.h). Layers at the nodes of each failing face, or at those
// nearest to it, become thinner, and finally end; immediately if the fault is between two stacks, where thinner
// layers do not help. Without layers the mesh is unchanged, so this terminates.
//
// Each region has its layers as if it were the only one: on its boundary, and on its side of interfaces. These do not
// change, and both sides share their faces (SharedNodes.h).
//
// Source: ours; the paper has no layers. The idea of moving the mesh away from the wall and filling the gap, thinner where it fails,
// is that of snappyHexMesh's addLayersControls.
// Limits: after everything else, so that layers adapt to the mesh and not it to them; none where a node has no direction that all
// its faces see; half of the work is on one thread; in parts, each part makes the layers of the whole mesh.
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
  int wanted =
    0; // layers that would lead to the last one's usual part of a box (layersTo), may be too many
  std::size_t boxesAdded = 0; // because walls with layers bend in them
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
