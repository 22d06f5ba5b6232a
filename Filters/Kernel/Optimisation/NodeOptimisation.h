// SPDX-License-Identifier: BSD-3-Clause
// Nodes along the wall move until the faces around them are within preferred quality limits.
//
// Cells are correct after cutting and merging, but irregular: face centres lie off the line between the cell centres,
// weights are small. An objective (FaceEnergy.h) sums this up. In each of a fixed number of rounds all nodes of wall
// cells take a step against its gradient at the same time, and revert steps that did not help; then the faces that
// are still poor are repaired one by one (WorstFaces.h). The result is the same for any number of threads and parts
// of a mesh. Like the smoothing of other meshers, but with one objective, and surface nodes never leave the surface.
#pragma once

#include "Optimisation/NodeMesh.h"
#include "Optimisation/WorstFaces.h"
#include "Surface/WallLayerSpec.h"

namespace cartesian
{

// A hexahedron whose corners may have moved.
struct MovedHexahedron
{
  std::uint32_t box;
  CellGeometry geometry; // from the lower corner of its box
};

struct Optimised
{
  std::vector<std::uint32_t> changed; // cells of polyhedral boxes
  std::vector<MovedHexahedron> hexahedra;
  std::vector<std::vector<FaceEdit>> edits; // of each slab, to be made in the wall mesh
};

enum class NodesMove
{
  All,        // together, then those of poor faces individually
  AtPoorFaces // one by one
};

// Moves nodes in the free layers of each slab; gives the cells around them their new volumes. The slabs must not
// touch. `featureAngle` in degrees: edges of the boundary that turn by more than this stay. `layers`: those requested
// on walls, or null.
Optimised optimiseNodes(const Boxes& boxes, const Sides& sides, const std::vector<Slab>& slabs,
  double featureAngle, const WallLayerSpec* layers, NodesMove move, Nodes& nodes, WallMesh& wall,
  Execution& execution);

}
