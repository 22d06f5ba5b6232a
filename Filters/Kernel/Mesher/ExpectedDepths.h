// SPDX-License-Identifier: BSD-3-Clause
// How deeply boxes at the surface will be divided, and where the grid ends, before meshing.
#pragma once

#include "Base/Execution.h"
#include "Mesher/Options.h"
#include "Surface/Surface.h"

#include <cstdint>
#include <vector>

namespace cartesian
{

struct ExpectedDepths
{
  Bounds grid; // user units

  // Of each triangle of the view, at its centre: the depth of the box there, and its longest edge in user units. Empty
  // if too many boxes would have to be examined.
  std::vector<std::uint8_t> depths;
  std::vector<double> sizes;
};

// With all refinement in the options. Boxes next to smaller ones may be smaller still, for the transition between them.
// Throws Error: as prepareSurface() and decompose().
ExpectedDepths expectedDepths(
  const SurfaceView& surface, const Options& options, Execution& execution);

}
