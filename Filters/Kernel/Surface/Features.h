// SPDX-License-Identifier: BSD-3-Clause
// Finds the sharp features of the surface (section 4.7): edges at which it turns by more than the
// feature angle, or, where its edges are known (FeatureEdgeTags.h), those that are known to be sharp.
//
// A thin triangle that is flipped between two sound ones is folded geometry (section 1): its edges
// are not features.
#pragma once

#include "Lattice/Vector.h"
#include "Surface/PointKind.h"
#include "Surface/Surface.h"

namespace cartesian
{

struct Features
{
  // Bits of each triangle. Bit i: its edge from corner i to the next is sharp. Bit 3 + i: that edge
  // is a border between boundaries. Bit 6: the triangle is folded geometry. Bit 7: a corner of it is on such an edge.
  std::vector<std::uint8_t> edges;
  std::vector<Vector> normal;      // unit normal of each triangle; zero if it has no area
  std::vector<PointKind> ofVertex; // of each vertex of the surface

  bool isSharp(std::size_t triangle, unsigned edge) const
  {
    return (edges[triangle] >> edge & 1) != 0;
  }

  bool isFold(std::size_t triangle) const { return (edges[triangle] >> 6 & 1) != 0; }

  // Bits 0 to 2: whether that edge is sharp or a border.
  unsigned lines(std::size_t triangle) const
  {
    return (edges[triangle] | edges[triangle] >> 3) & 7u;
  }

  // Else no part of the triangle is more than on the surface.
  bool touchesFeature(std::size_t triangle) const { return edges[triangle] >> 7 != 0; }

  // Whether a sharp edge or a border of this triangle ends in one of its corners.
  bool endsIn(std::size_t triangle, unsigned corner) const
  {
    const unsigned any = lines(triangle);
    return (any >> corner & 1) != 0 || (any >> (corner + 2) % 3 & 1) != 0;
  }
};

// `featureAngle`: in degrees, 0 to 180. Open and non-manifold edges are sharp.
Features findFeatures(const Surface& surface, double featureAngle, Execution& execution);

}
