// SPDX-License-Identifier: BSD-3-Clause
// Sharp features of the surface (section 4.7): edges at which it turns by more than an angle.
//
// A thin triangle turned over between two healthy ones is folded geometry (section 1): its edges are
// no features.
#pragma once

#include "Lattice/Vector.h"
#include "Surface/Surface.h"

namespace cartesian
{

struct Features
{
  // Of each triangle. Bit i: its edge from corner i to the next is sharp; bit 3 + i: that edge is a
  // border between boundaries. Bit 6: it is folded geometry.
  std::vector<std::uint8_t> edges;
  std::vector<Vector> normal; // of each triangle, of length 1; 0 where it has no area

  bool isSharp(std::size_t triangle, unsigned edge) const
  {
    return (edges[triangle] >> edge & 1) != 0;
  }

  bool isFold(std::size_t triangle) const { return (edges[triangle] >> 6 & 1) != 0; }

  // Whether a sharp edge or a border ends in a corner of a triangle, as far as that one knows.
  bool endsIn(std::size_t triangle, unsigned corner) const
  {
    const unsigned any = edges[triangle] | edges[triangle] >> 3;
    return (any >> corner & 1) != 0 || (any >> (corner + 2) % 3 & 1) != 0;
  }
};

// `featureAngle` in degrees, from 0 to 180. Open and non-manifold edges are sharp.
Features findFeatures(const Surface& surface, double featureAngle, Execution& execution);

}
