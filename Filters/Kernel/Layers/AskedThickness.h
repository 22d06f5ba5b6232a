// SPDX-License-Identifier: BSD-3-Clause
// How thick all layers together are to be at each place: a length, or a part of the box there.
#pragma once

#include "Mesh/OutputMesh.h"
#include "Surface/WallLayerSpec.h"

namespace cartesian
{

// At each face, in user units, where its boundary has no thickness of its own.
std::vector<double> usualThicknesses(
  const OutputMesh& mesh, const std::vector<BoundaryFace>& faces, const WallLayerSpec& spec);

}
