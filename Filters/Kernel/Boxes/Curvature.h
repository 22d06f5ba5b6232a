// SPDX-License-Identifier: BSD-3-Clause
// Boxes to be divided because the surface curves in them, or a sharp edge passes through.
#pragma once

#include "Boxes/Octants.h"
#include "Boxes/Shoeboxes.h"

#include <functional>

namespace cartesian
{

// What bends too much, and how deep boxes there are for it.
struct BendSpec
{
  double angle;                      // degrees, 0 to 180; 0: nothing does
  int featureDepth;                  // of boxes that a sharp edge passes through
  double featureAngle;               // degrees: edges at which the surface turns by more are sharp
  std::vector<std::uint8_t> looksAt; // each triangle; empty: all

  // Of a global box: how deep all boxes at the surface there are anyway, and the largest depth for the angle.
  std::function<std::pair<int, int>(const std::array<std::uint32_t, 3>& global)> depths;
};

// Appends octants of all global boxes that the surface passes through. In each the surface turns by at most
// the angle, or it has the largest depth: any two triangles in it that are connected there, around vertices
// and over edges which are not sharp, have normals so close.
void addBends(const BendSpec& spec, const Surface& surface, const Shoeboxes& shoeboxes,
  const Meshlines& planes, Octants& octants, Execution& execution);

}
