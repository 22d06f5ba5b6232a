// SPDX-License-Identifier: BSD-3-Clause
// The requested total thickness of layers at each place: a length, or a part of the box there.
#pragma once

#include "Mesh/OutputMesh.h"
#include "Surface/WallLayerSpec.h"

namespace cartesian
{

// At each face, in user units, if its boundary does not have its own thickness.
std::vector<double> usualThicknesses(
  const OutputMesh& mesh, const std::vector<BoundaryFace>& faces, const WallLayerSpec& spec);

}
