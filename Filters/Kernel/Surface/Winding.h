// SPDX-License-Identifier: BSD-3-Clause
// How the surface winds around a point (section 4.4).
#pragma once

#include <cstdint>

namespace cartesian
{

// The winding number of a point: crossings of the surface on a path to it from outside, inward as
// +1, outward as -1. Components without a consistent orientation (Surface::byParity) are counted
// separately, modulo 2.
//
// A point is inside if the surface winds around it at least once, so bodies that overlap are one
// body. For a surface that does not intersect itself, this is the parity of the crossings.
struct Winding
{
  std::int32_t turns = 0;
  bool odd = false;

  bool inside() const { return (turns > 0) != odd; }

  // Of a surface with walls (Walls.h): each crossing adds the difference of the regions' numbers.
  std::int32_t region() const { return turns; }

  // Continues the path along `other`, forwards or back.
  Winding& add(const Winding& other, bool back = false)
  {
    turns += back ? -other.turns : other.turns;
    odd = odd != other.odd;
    return *this;
  }

  bool operator==(const Winding& other) const { return turns == other.turns && odd == other.odd; }
};

}
