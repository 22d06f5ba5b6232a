// SPDX-License-Identifier: BSD-3-Clause
// The nodes of all faces, numbered (section 7.1), hanging nodes included.
#pragma once

#include "Boxes/Sides.h"
#include "Patches/Patches.h"

#include <tuple>

namespace cartesian
{

// A node that is a vertex (i, j, k) of the global mesh.
struct VertexNode
{
  std::uint32_t k;
  std::uint32_t j;
  std::uint32_t i;
  std::uint32_t node;

  bool operator<(const VertexNode& other) const
  {
    return std::make_tuple(k, j, i) < std::make_tuple(other.k, other.j, other.i);
  }
};

// Of a corner of an undivided box, without its node.
inline VertexNode vertexAt(const Boxes& boxes, std::uint32_t box, unsigned corner)
{
  const auto& low = boxes.globalOf(boxes.packed[box]).index;
  return { low[2] + (corner >> 2 & 1), low[1] + (corner >> 1 & 1), low[0] + (corner & 1), None };
}

// First the points of patches; then grid nodes: corners of sides, nodes that hang on their borders and
// corners of divided hexahedra; then the nodes that edits add (Editing).
struct Nodes
{
  std::vector<Point> at;
  RawVector<PointKind> kinds; // of all but those that edits add
  std::size_t patchPoints = 0;
  std::vector<Point> grid;           // where grid nodes were before edits moved them
  std::vector<std::size_t> rowStart; // first grid node of each row of points (Numbering.h), from 0
  std::vector<std::size_t> borderStart; // first node of each side's border, and the end
  std::vector<std::uint32_t> border;    // grid nodes counter-clockwise from the lowest corner
  std::vector<std::array<std::uint32_t, 8>> ofDivided; // corners of Sides::divided
  std::vector<VertexNode> moreVertices; // nodes that edits add at vertices of the global mesh
  std::vector<std::uint32_t> ofCuts;    // the other nodes that edits add, in order of places

  // Once inner faces are made.
  void forgetBorders()
  {
    std::vector<std::size_t>().swap(borderStart);
    std::vector<std::uint32_t>().swap(border);
  }
};

// The node at a corner of a hexahedron if it is one of a side, a border or a divided box, else None.
std::uint32_t nodeOfCorner(
  const Boxes& boxes, const Sides& sides, const Nodes& nodes, std::uint32_t box, unsigned corner);

Nodes findNodes(
  const Boxes& boxes, const Patches& patches, const Sides& sides, Execution& execution);

}
