// SPDX-License-Identifier: BSD-3-Clause
// The worst faces are repaired one by one, the worst first: their nodes move (NodeMoves.h), short edges collapse, faces
// of a cell merge (FaceProposals.h). Of all possible edits of a face the best is made (EditTrials.h), if the objective
// (MeshEnergy.h) of everything that it changes falls; volume added or removed counts too. Good faces are examined once.
//
// Edges of the wall that are sharper than the feature angle, corners and borders of boundaries stay where they are, by the
// rules of NodePaths.h. The order follows from places alone: results do not depend on that of the input.
#pragma once

#include "Base/Execution.h"
#include "Optimisation/Mending.h"

namespace cartesian
{

// `energy` is of the mesh as it is. Nodes come to whole levels. Returns the edits still to be applied to the wall
// mesh's faces, in order.
std::vector<FaceEdit> mendWorstFaces(
  const MendingTask& task, MeshEnergy& energy, Execution& execution);

}
