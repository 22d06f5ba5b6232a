// SPDX-License-Identifier: BSD-3-Clause
// The worst faces are mended one by one, the worst first: their nodes move, short edges collapse, faces of a cell become
// one. Of all edits that are possible at a face the best is made, if the objective (MeshEnergy.h) of all that it changes
// falls; what it adds to the mesh or takes from it counts as well. Good faces cost one look.
//
// Edges of the wall that are sharper than the feature angle, corners and borders of boundaries stay where they are, by the
// rules of NodePaths.h. The order follows from places alone: results do not depend on that of the input.
#pragma once

#include "Base/Execution.h"
#include "Optimisation/FaceEdits.h"
#include "Optimisation/MeshEnergy.h"
#include "Optimisation/NodePaths.h"

namespace cartesian
{

// What is mended; borrowed.
struct MendingTask
{
  NodeMesh& mesh;
  const NodePaths& paths;
  const LayerPrisms& prisms;         // where there are any, only nodes move
  const std::vector<Vector>& before; // where nodes were in the beginning
  const std::vector<double>& edges;  // of boxes, of each face
  double featureCosine;              // faces of the wall that turn by more are not joined
};

// `energy` is of the mesh as it is. Nodes come to whole levels. Returns what is left to be done to the wall mesh: edits
// of its faces, in order.
std::vector<FaceEdit> mendWorstFaces(
  const MendingTask& task, MeshEnergy& energy, Execution& execution);

}
