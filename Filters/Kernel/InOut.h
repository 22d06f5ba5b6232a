// In/Out Status (section 4.4) of the vertices of the global mesh, for whole rows at once.
#pragma once

#include "LineCrossings.h"
#include "SurfaceCheck.h"

namespace cartesian
{

// On a closed surface the parity of the crossings below a vertex along x is its status: planes
// are shifted so that no ray touches an edge (Crossing.h), hence all six rays agree. Where the
// surface is open they may not: then the majority of the six rays decides, a draw is outside.
class InOut
{
public:
  InOut(const Surface& surface, const SurfaceCheck& check, const Meshlines& planes,
    Execution& execution);

  bool inside(std::uint32_t i, std::uint32_t j, std::uint32_t k) const;

  // Bits of the eight corners of global box i, j, k as in Box::corners.
  std::uint8_t corners(std::uint32_t i, std::uint32_t j, std::uint32_t k) const;

private:
  bool vote(const std::array<std::uint32_t, 3>& vertex) const;
  static int votes(const LineCrossings& lines, const std::array<std::uint32_t, 3>& vertex);

  bool closed_;
  std::vector<LineCrossings> along_; // x; y and z too where the surface is open
};

}
