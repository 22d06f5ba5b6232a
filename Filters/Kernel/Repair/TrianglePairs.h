// SPDX-License-Identifier: BSD-3-Clause
// What two triangles have in common besides corners and edges (step 4), exactly.
#pragma once

#include "Lattice/Vector.h"
#include "Surface/Surface.h"

namespace cartesian
{

enum class Contact
{
  Apart,    // at most single points, and a common edge
  Crossing, // they share a stretch of a line
  Overlap,  // they lie in one plane and share an area
};

// Both have an area. Decided by signs of determinants of lattice points; where all four points of one
// are zero the triangles lie in one plane. Triangles with a common edge only ever overlap.
Contact contactOf(const Surface& surface, std::uint32_t a, std::uint32_t b);

// The ends of the stretch that two crossing triangles share, in levels.
std::array<Vector, 2> stretchOf(const Corners& a, const Corners& b);

// Triangles whose bounds meet.
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

struct TrianglePairs
{
  std::vector<TrianglePair> pairs;    // in order
  std::vector<std::uint32_t> givenUp; // triangles that meet the bounds of too many, in order
};

// All pairs that cross or overlap, of triangles that have an area. Looks at no more than 512 larger
// triangles around each, at fewer (down to 64) where there are more than 60 000: beyond it is given up.
TrianglePairs findPairs(const Surface& surface, Execution& execution);

}
