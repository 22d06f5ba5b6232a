// SPDX-License-Identifier: BSD-3-Clause
// Hexahedra with corners that moved onto the surface (Editing/ShortEdges.h), and their volumes.
#pragma once

#include "Faces/Nodes.h"

namespace cartesian
{

// In order of kinds (undivided, divided), then of boxes; volume fractions are of the box.
std::vector<WarpedHexahedron> warpedHexahedra(
  const Boxes& boxes, const Sides& sides, const Nodes& nodes, Execution& execution);

}
