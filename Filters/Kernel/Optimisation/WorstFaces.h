// SPDX-License-Identifier: BSD-3-Clause
// The worst faces are mended one by one, the worst first: their nodes move (NodeMoves.h), short edges collapse, faces of a
// cell become one (FaceProposals.h). Of all edits that are possible at a face the best is made (EditTrials.h), if the
// objective (MeshEnergy.h) of all that it changes falls; what it adds to the mesh or takes from it counts as well. Good
// faces cost one look.
//
// Edges of the wall that are sharper than the feature angle, corners and borders of boundaries stay where they are, by the
// rules of NodePaths.h. The order follows from places alone: results do not depend on that of the input.
#pragma once

#include "Base/Execution.h"
#include "Optimisation/Mending.h"

namespace cartesian
{

// `energy` is of the mesh as it is. Nodes come to whole levels. Returns what is left to be done to the wall mesh: edits
// of its faces, in order.
std::vector<FaceEdit> mendWorstFaces(
  const MendingTask& task, MeshEnergy& energy, Execution& execution);

}
