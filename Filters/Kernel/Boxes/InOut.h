// SPDX-License-Identifier: BSD-3-Clause
// In/Out Status (section 4.4) of the vertices of the global mesh.
#pragma once

#include "Surface/LineCrossings.h"

namespace cartesian
{

// How the surface winds around a vertex, from the crossings below it along x. All six rays of the
// paper would give the same answer: in each component, edges have as many triangles in one
// direction as in the other, or at least an even number (SurfaceRepair.h), and planes are shifted
// so that no ray touches an edge (Crossing.h).
class InOut
{
public:
  InOut(const Surface& surface, const Meshlines& planes, Execution& execution)
    : alongX_(surface, planes, 0, execution)
  {
  }

  Winding at(std::uint32_t i, std::uint32_t j, std::uint32_t k) const
  {
    return alongX_.at(j, k, i);
  }

  // The bits of the eight corners of global box i, j, k, as in Box::corners.
  std::uint8_t corners(std::uint32_t i, std::uint32_t j, std::uint32_t k) const
  {
    unsigned bits = 0;
    for (unsigned corner = 0; corner < 8; ++corner)
    {
      const bool in = at(i + (corner & 1), j + (corner >> 1 & 1), k + (corner >> 2)).inside();
      bits |= unsigned(in) << corner;
    }
    return static_cast<std::uint8_t>(bits);
  }

private:
  LineCrossings alongX_;
};

}
