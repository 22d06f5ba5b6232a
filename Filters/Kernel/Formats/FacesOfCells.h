// SPDX-License-Identifier: BSD-3-Clause
// The faces of each cell of a mesh, for formats whose cells list them.
#pragma once

#include "OpenFoam/PolyMeshFiles.h"

namespace cartesian
{

struct OrientedFace
{
  std::uint32_t face;
  bool pointsInward; // the cell is its neighbour, not its owner
};

struct FacesOfCells
{
  explicit FacesOfCells(const FoamMesh& mesh);

  std::vector<std::size_t> start; // of each cell in `uses`, and the end
  std::vector<OrientedFace> uses; // ascending
};

}
