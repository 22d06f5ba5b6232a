// SPDX-License-Identifier: BSD-3-Clause
// Boundary faces with requested layers: a prism on each, so that nodes also bring the faces between layers within
// preferred quality limits. Its height is a part of the box's, as that of layers matters little here: faults of a stack
// of prisms are those of the polygon below.
#pragma once

#include "Optimisation/NodeMesh.h"
#include "Surface/WallLayerSpec.h"

namespace cartesian
{

struct LayerPrisms
{
  std::uint32_t firstNode = 0;      // of those on top, the last of the mesh's nodes
  std::vector<std::uint32_t> below; // the node that each of them follows
  std::vector<Vector> offset;
  std::uint32_t firstCell = 0;      // of the prisms, the last of the changing cells
  std::vector<std::uint8_t> counts; // of each face: 0 for those between a prism and no known cell

  void follow(std::vector<Vector>& at) const
  {
    for (std::size_t i = 0; i < below.size(); ++i)
    {
      at[firstNode + i] = plus(at[below[i]], offset[i]);
    }
  }
};

// Adds them to the mesh. `layers` null: none.
LayerPrisms addPrisms(NodeMesh& mesh, const WallLayerSpec* layers);

}
