// SPDX-License-Identifier: BSD-3-Clause
// The cells along the wall in one slab (Slabs.h) as one flat mesh, for all that moves their nodes.
//
// Nodes come in order of their places, faces in order of their nodes: sums over them come out the same, bit for bit, in
// whatever order the surface's triangles came.
#pragma once

#include "Cells/Cells.h"
#include "Parts/Slabs.h"
#include "Polyhedra/CellGeometry.h"

namespace cartesian
{

// The mesh of which a wall mesh is a part, as it is now.
struct WallParts
{
  WallParts(const Boxes& boxes, const Patches& patches, const Sides& sides, const Nodes& nodes,
    const InnerFaces& inner, const Cells& cells, const std::vector<std::uint32_t>& sideOf);

  const Boxes& boxes;
  const Patches& patches;
  const Sides& sides;
  const Nodes& nodes;
  const InnerFaces& inner;
  const Cells& cells;
  const std::vector<std::uint32_t>& sideOf; // of each inner face
  std::vector<std::uint32_t> hexahedronAt; // the box of the hexahedron at each shaped face, or None
  std::vector<std::uint8_t>
    isVertex; // of nodes that shaping added: 1 at vertices of the global mesh
};

struct WallMesh
{
  // Nodes. Places are in levels from `origin`.
  Point origin{};
  std::array<Vector, 2> ends{}; // of the grid, lowest and highest: nodes stay between them
  std::vector<Vector> at;
  std::vector<std::uint32_t>
    number; // in Nodes, or None: corners of hexahedra that only hexahedra have
  std::vector<std::uint8_t> mayMove; // 1: all cells at the node are here, and it is a wall cell's

  // Faces; the corners are counter-clockwise seen from outside the cell below.
  std::vector<std::uint32_t> start{ 0 };
  std::vector<std::uint32_t> corners;
  std::vector<std::array<std::uint32_t, 2>> cells; // below and above; None above: a boundary face
  std::vector<std::int32_t> boundary; // of boundary faces, and of those between two regions

  // Cells: first those with a node that may move, whose faces are all here; then their neighbours, which keep their
  // measures.
  std::size_t changing = 0;
  std::vector<std::uint32_t> cellStart; // of the first of each changing cell's faces, and the end
  std::vector<std::uint32_t> cellFaces;
  std::vector<CellGeometry> measures;
  std::vector<double> volumeOfBox;
  std::vector<std::uint32_t> cell; // in Cells, or None: a hexahedron
  std::vector<std::int32_t> region;

  std::size_t faces() const { return cells.size(); }

  bool isInterface(std::size_t f) const
  {
    return cells[f][1] != None && region[cells[f][0]] != region[cells[f][1]];
  }
  bool isWall(std::size_t f) const { return cells[f][1] == None || isInterface(f); }
};

WallMesh wallMesh(const WallParts& parts, const Slab& slab);

}
