// SPDX-License-Identifier: BSD-3-Clause
// Exact test of how two triangles intersect, apart from shared corners and edges (step 4).
#pragma once

#include "Lattice/Vector.h"
#include "Surface/Surface.h"

#include <limits>

namespace cartesian
{

class TriangleTree;

enum class Contact
{
  Apart,    // share at most single points and a common edge
  Crossing, // share a line segment
  Overlap,  // are coplanar and share an area
};

// Of two triangles that have an area. Decided by the signs of determinants of lattice points; if they are all zero,
// the triangles are coplanar. Triangles with a common edge can overlap, but not cross.
Contact contactOf(const Surface& surface, std::uint32_t a, std::uint32_t b);

// The ends of the segment that two crossing triangles share, in levels.
std::array<Vector, 2> sharedSegment(const Corners& a, const Corners& b);

struct TrianglePair
{
  std::uint32_t first; // the lower number
  std::uint32_t second;
  Contact contact;

  bool operator<(const TrianglePair& other) const
  {
    return first != other.first ? first < other.first : second < other.second;
  }
};

// Whether the two have the same three corners.
bool haveSameCorners(const Surface& surface, const TrianglePair& pair);

struct TrianglePairs
{
  std::vector<TrianglePair> pairs;    // in order
  std::vector<std::uint32_t> givenUp; // triangles with too many neighbours, in order
};

// All pairs of triangles (that have an area) which cross or overlap. In all, 10 million pairs are compared, or 64 per
// triangle if that is more: each with 64 larger ones nearby, then those with more neighbours, with as many as are
// left for each. The rest is not compared.
TrianglePairs findPairs(const Surface& surface, Execution& execution);

// The same with the tree of the surface.
TrianglePairs findPairs(const Surface& surface, const TriangleTree& tree, Execution& execution);

// Then those of different bodies also overlap where one is so near the other's plane, as coplanar faces are that
// the lattice rounded.
struct NearlyFlat
{
  std::vector<std::uint32_t> body; // of each triangle
  double distance;                 // levels
  std::vector<std::uint8_t>
    isNew; // of each triangle: pairs of others are not looked for; empty: all are new

  // Of pairs that do not have the same corners: where there are so many, the search ends, and may not return all.
  std::size_t enough = std::numeric_limits<std::size_t>::max();
};
TrianglePairs findPairs(const Surface& surface, const NearlyFlat& nearly, Execution& execution);

}
