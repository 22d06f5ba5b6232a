// SPDX-License-Identifier: BSD-3-Clause
// How deeply boxes at the surface will be divided, and where the grid ends, before meshing.
#pragma once

#include "Base/Execution.h"
#include "Mesher/Options.h"
#include "Surface/Surface.h"

#include <array>
#include <cstdint>
#include <vector>

namespace cartesian
{

struct ExpectedDepths
{
  Bounds grid; // user units

  // At each place: how many times the box there is halved, and its longest edge in user units. Empty if that would take
  // too long.
  std::vector<std::uint8_t> depths;
  std::vector<double> sizes;
};

// With all refinement in the options, at `given` places on the surface, in user units. Boxes next to smaller ones may be smaller
// still, for the transition between them. Throws Error: as prepareSurface() and decompose().
ExpectedDepths expectedDepths(const SurfaceView& view, const Options& options,
  const std::vector<std::array<double, 3>>& given, Execution& execution);

// Whether boxes along the surface may differ in depth.
bool hasSeveralDepths(const Options& options);

}
