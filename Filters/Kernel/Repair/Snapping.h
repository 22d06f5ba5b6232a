// SPDX-License-Identifier: BSD-3-Clause
// What an arrangement (Arrangement.h) treats as coincident: anything closer than the file's precision.
#pragma once

#include "Base/DisjointSets.h"
#include "Surface/Surface.h"

#include <array>
#include <unordered_map>

namespace cartesian
{

// Precision of places, in levels, of which the longest side of the domain has more than 2^30.
struct Placing
{
  // Faces within this distance are coplanar: the file rounds both, and so does the lattice.
  double together;

  // A new vertex this close to another, or to an edge, is merged with it or lies on it. Not more: bodies further apart
  // than that are given so.
  double reach;

  // Pieces of faces are coplanar within this distance: snapping moves them.
  double piecesTogether;

  // Edges that run along each other meet in places that differ by many roundings: a sheet of twice this thickness
  // has reliable sides.
  double snap;

  // Whether better angles may not cost a triangle's edge its vertices: flips then make no slivers of three of them,
  // which folding would have to remove again and again.
  bool keepsEdges = false;
};

Placing placingOf(const Surface& surface);

// Others to try in turn where triangles still cross in the end. Vertices keep more of their places, and pieces are only
// coplanar where they are so exactly: slivers have no plane that would tell.
std::array<Placing, 4> otherPlacingsOf(const Surface& surface);

// Finds vertices by their places, and makes new ones.
class VertexIndex
{
public:
  // Borrows the vertices, which are given ones; `reach`: levels.
  VertexIndex(std::vector<Point>& vertices, double reach);

  // The nearest vertex within the reach, the first of equally near ones; otherwise a new one.
  std::uint32_t at(const Point& place);

  // Makes two vertices that are an edge apart one, if that edge is short and one of them is new.
  bool merge(std::uint32_t p, std::uint32_t q);

  // The vertex that a vertex was merged with.
  std::uint32_t vertexFor(std::uint32_t v) { return same_.find(v); }

private:
  static constexpr std::uint32_t None = ~0u;

  std::uint64_t keyOf(const Point& p, const std::array<int, 3>& aside = { 0, 0, 0 }) const;
  void add(std::uint32_t v);

  std::vector<Point>& vertices_;
  double reach_;          // levels
  unsigned cellBits_ = 0; // cells are no smaller than that
  std::size_t given_;     // what follows is new
  DisjointSets same_;
  std::unordered_map<std::uint64_t, std::uint32_t> cells_; // the last vertex in a cell
  std::vector<std::uint32_t> next_;                        // of each vertex, another in its cell
};

}
