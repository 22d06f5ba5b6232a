// SPDX-License-Identifier: BSD-3-Clause
// How the surface winds around a point (section 4.4).
#pragma once

#include <cstdint>

namespace cartesian
{

// Crossings on the way from outside to a point: of the surface into it as +1 and out of it as -1; of
// triangles whose component has no consistent orientation (Surface::byParity) only how many, modulo 2.
//
// A point is inside where the surface winds around it once or more, so bodies that overlap are one body.
// On a surface that does not cross itself this is the parity of the crossings.
struct Winding
{
  std::int32_t turns = 0;
  bool odd = false;

  bool inside() const { return (turns > 0) != odd; }

  // On the same way there, or back.
  Winding& add(const Winding& other, bool back = false)
  {
    turns += back ? -other.turns : other.turns;
    odd = odd != other.odd;
    return *this;
  }

  bool operator==(const Winding& other) const { return turns == other.turns && odd == other.odd; }
};

}
