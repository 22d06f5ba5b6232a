// SPDX-License-Identifier: BSD-3-Clause
// The boundary of a region that gets layers, and where its nodes move.
#pragma once

#include "Layers/FlowDomainSides.h"
#include "Layers/LayerRegion.h"
#include "Surface/WallLayerSpec.h"

namespace cartesian
{

struct LayeredWall
{
  LayerRegion of;                    // without layers
  std::vector<std::uint8_t> layered; // of each face
  std::vector<double> asked; // thickness of all layers on each face, in user units; 0: it has none
  std::vector<double>
    usual; // of each node, where boundaries do not have their own thickness; the most of its faces
  std::vector<std::uint8_t>
    isOnWall;                // of each node, an index in of.mesh.meshPoint: it is of a layered face
  std::vector<Vector> place; // of each node, in user units

  // Of each node on the wall, the way inwards through all layers, to where the planes of the faces around it meet
  // (OffsetPlanes.h); it is within the planes of boundaries without layers. Others: 0.
  std::vector<Vector> way;

  // Of each node, the normals of the planes of boundaries without layers around it (orthogonal): where it may slide.
  std::vector<std::vector<Vector>> fixed;

  // ... of each node on the wall, those across which its way is certain: others come from nodes beside it.
  std::vector<std::vector<Vector>> across;

  // The part of its way that layers take; the mesh's point moves there. 0: it has none.
  std::vector<double> parts;

  // Of each face's corners, as in of.mesh.corners, the face beyond the edge from there to the next corner, and that
  // face's corner from which the edge goes back; itself where there are not two faces at an edge.
  std::vector<std::size_t> beyond;
  std::vector<std::size_t> opposite;

  std::size_t nodes() const { return place.size(); }
  std::size_t corners(std::size_t face) const
  {
    return static_cast<std::size_t>(of.mesh.start[face + 1] - of.mesh.start[face]);
  }
  std::size_t corner(std::size_t face, std::size_t i) const
  {
    return static_cast<std::size_t>(of.mesh.start[face]) + i % corners(face);
  }
  std::size_t cornerAfter(std::size_t face, std::size_t corner) const
  {
    const bool isLast = corner + 1 == static_cast<std::size_t>(of.mesh.start[face + 1]);
    return isLast ? static_cast<std::size_t>(of.mesh.start[face]) : corner + 1;
  }
  std::size_t node(std::size_t face, std::size_t i) const
  {
    return static_cast<std::size_t>(of.mesh.corners[corner(face, i)]);
  }

  std::size_t faceBeyond(std::size_t face, std::size_t i) const { return beyond[corner(face, i)]; }

  // `height`: a part of the way.
  Vector at(std::size_t node, double height) const
  {
    return plus(place[node], scaled(way[node], height));
  }
  bool hasStack(std::size_t face) const;

  // Whether its stack has no height at one of its nodes.
  bool tapers(std::size_t face) const;

  // Whether all layers have one common side over an edge: neither side of it has layers that differ.
  bool isWhole(std::size_t face, std::size_t i) const;

  // Of all layers on a face: the mean of its nodes, along the normal of the wall.
  double thickness(std::size_t face) const;
};

// `points`: of the mesh.
LayeredWall findLayeredWall(LayerRegion region, const OutputMesh& mesh,
  const std::vector<double>& points, const WallLayerSpec& spec, Execution& execution);

// Lowers the parts of nodes until layers take at most a third of the way to what lies opposite: the surface, or a side
// of the flow domain.
void keepFromOpposite(
  LayeredWall& wall, const Surface& surface, const FlowDomainSides& sides, Execution& execution);

}
