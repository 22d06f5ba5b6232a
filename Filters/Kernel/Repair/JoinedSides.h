// SPDX-License-Identifier: BSD-3-Clause
// Which sides of triangles that do not cross are next to the same space.
//
// Around each edge, what is between two neighbouring triangles is one space: so the sides of triangles are joined
// edge by edge. Neighbours are found by exact orientation (RadialEdgeSort.h); what is open at a rim connects its two
// sides. Parts that share no edge are placed in each other by a line through each, which joins what lies next to each
// other along it.
// Limits: a part of a few levels, which no line meets, is nowhere.
#pragma once

#include "Base/DisjointSets.h"
#include "Repair/RayCrossings.h"
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

class JoinedSides
{
public:
  JoinedSides(const Surface& surface, const std::vector<Piece>& pieces, Execution& execution);

  // Spaces are named by any number that their sides have in common. The one around everything:
  std::uint32_t farAway() { return sides_.find(far_); }

  // The space in front of a piece, or behind it.
  std::uint32_t beside(std::uint32_t piece, bool front);

  // The space at a place, on even levels.
  std::uint32_t at(const Point& place);

private:
  void placeParts(DisjointSets& parts);
  bool joinAlongLine(std::uint32_t piece);
  bool cross(std::size_t along, const Point& place, std::vector<RayCrossing>& crossings) const;

  Surface flat_; // a triangle a piece
  DisjointSets sides_;
  TriangleTree tree_;
  std::uint32_t far_;
};

}
