// In/Out Status (section 4.4) of the vertices of the global mesh, for whole rows at once.
#pragma once

#include "LineCrossings.h"

namespace cartesian
{

// The parity of the crossings below a vertex along x is its status. Every edge has an even number of
// triangles (SurfaceRepair.h) and planes are shifted so that no ray touches an edge (Crossing.h),
// hence all six rays of the paper agree.
class InOut
{
public:
  InOut(const Surface& surface, const Meshlines& planes, Execution& execution)
    : alongX_(surface, planes, 0, execution)
  {
  }

  bool inside(std::uint32_t i, std::uint32_t j, std::uint32_t k) const
  {
    return alongX_.below(j, k, i) % 2 == 1;
  }

  // Bits of the eight corners of global box i, j, k as in Box::corners.
  std::uint8_t corners(std::uint32_t i, std::uint32_t j, std::uint32_t k) const
  {
    unsigned bits = 0;
    for (unsigned corner = 0; corner < 8; ++corner)
    {
      const bool in = inside(i + (corner & 1), j + (corner >> 1 & 1), k + (corner >> 2));
      bits |= unsigned(in) << corner;
    }
    return static_cast<std::uint8_t>(bits);
  }

private:
  LineCrossings alongX_;
};

}
