// SPDX-License-Identifier: BSD-3-Clause
// The boundary of a region that gets layers, and where its nodes move.
#pragma once

#include "Layers/FlowDomainSides.h"
#include "Layers/LayerRegion.h"
#include "Polyhedra/CellGeometry.h"
#include "Surface/WallLayerSpec.h"

namespace cartesian
{

// Why layers are thinner at a node than requested, or end there.
enum class LayerEnd : std::uint8_t
{
  Nowhere = 0,
  Gap = 1,    // something lies opposite
  Corner = 2, // the wall leaves no way inwards, or has no unique neighbour there
  Fault = 3,  // of a cell or face that would fail with them
};

struct LayeredWall
{
  LayerRegion of;                    // without layers
  std::vector<std::uint8_t> layered; // of each face
  std::vector<double> asked; // thickness of all layers on each face, in user units; 0: it has none
  std::vector<double>
    usual; // of each node, where boundaries do not have their own thickness; the most of its faces
  std::vector<std::uint8_t>
    isOnWall; // of each node, an index in of.mesh.meshPoint: it is of a layered face
  std::vector<std::uint8_t>
    isFlat; // of each node: on all of its layered faces the first layer is low, by the box beside it
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

  std::vector<LayerEnd> ends; // of each node

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

  bool isFlatFace(std::size_t face) const;

  // The most certain reason of its nodes.
  LayerEnd endOn(std::size_t face) const;

  double area(std::size_t face) const
  {
    return norm(measureFace(corners(face), [&](std::size_t i) -> const Vector& {
      return place[node(face, i)];
    }).area);
  }

  // Of parts of the ways on a face, partOf(node): the mean of its nodes, along the normal of the wall.
  template <class PartOf>
  double heightOn(std::size_t face, PartOf&& partOf) const;

  // Of all layers on a face.
  double thickness(std::size_t face) const
  {
    return heightOn(face, [&](std::size_t n) { return parts[n]; });
  }
};

template <class PartOf>
double LayeredWall::heightOn(std::size_t face, PartOf&& partOf) const
{
  const std::size_t size = corners(face);
  const Vector normal = unit(
    measureFace(size, [&](std::size_t i) -> const Vector& { return place[node(face, i)]; }).area);
  double sum = 0;
  for (std::size_t i = 0; i < size; ++i)
  {
    const std::size_t n = node(face, i);
    sum -= partOf(n) * dot(way[n], normal);
  }
  return sum / static_cast<double>(size);
}

// `points`: of the mesh.
LayeredWall findLayeredWall(LayerRegion region, const OutputMesh& mesh,
  const std::vector<double>& points, const WallLayerSpec& spec, Execution& execution);

// Lowers the parts of nodes until layers take at most a third of the way to what lies opposite: the surface, or a side
// of the flow domain.
void keepFromOpposite(
  LayeredWall& wall, const Surface& surface, const FlowDomainSides& sides, Execution& execution);

}
