// SPDX-License-Identifier: BSD-3-Clause
// The spaces into which triangles that do not cross divide the whole space.
//
// Around each edge, what is between two neighbouring triangles is one space: so the sides of triangles are joined
// edge by edge. Neighbours are found by exact orientation, and how closed bodies wind around a space follows from any
// other space across the triangles between (as libigl extracts cells and propagates winding numbers). Of each
// connected part one line decides how the others wind around it.
#pragma once

#include "Base/DisjointSets.h"
#include "Surface/SurfaceEdges.h"

namespace cartesian
{

// Triangles of the same three vertices.
struct Piece
{
  std::array<std::uint32_t, 3> vertices; // as the first of its triangles has them
  std::vector<std::uint32_t> triangles;  // of one body after the other
};

// Whether two triangles of the same vertices have the same normal.
bool faceAlike(const std::array<std::uint32_t, 3>& a, const std::array<std::uint32_t, 3>& b);

// Of triangles with an area, by body (Surface::region).
std::vector<Piece> piecesOf(const Surface& surface);

// Of a side of a piece, by its number.
constexpr std::uint32_t sideOf(std::uint32_t piece, bool front)
{
  return 2 * piece + (front ? 1 : 0);
}

// One triangle of each piece, in order.
Surface flatOf(const Surface& surface, const std::vector<Piece>& pieces);

// The sides of pieces, joined where the same space is next to both at an edge.
DisjointSets joinedSides(const Surface& flat, Execution& execution);

struct Spaces
{
  std::vector<std::array<std::uint32_t, 2>>
    beside; // of each piece: the space behind it, and in front
  std::vector<std::vector<std::int32_t>>
    turns; // of each space: how often each body winds around it, from 0 on
  std::vector<std::uint32_t>
    contradictions; // pieces across which bodies wind otherwise than they ought to: some cross
};

// Bodies are numbered from 1 to `bodies`, and closed.
Spaces findSpaces(const Surface& surface, const std::vector<Piece>& pieces, std::int32_t bodies,
  Execution& execution);

}
