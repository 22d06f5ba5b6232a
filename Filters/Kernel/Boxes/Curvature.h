// SPDX-License-Identifier: BSD-3-Clause
// Boxes to be divided because the surface curves in them, or a sharp edge passes through.
#pragma once

#include "Boxes/Octants.h"
#include "Boxes/Shoeboxes.h"
#include "Boxes/SizingSpec.h"

namespace cartesian
{

// Appends octants of all global boxes that the surface passes through. In each the surface turns by at most
// the curvature angle, or it has the largest depth: any two triangles in it that are connected there, around vertices
// and over edges which are not sharp, have normals so close.
void addBends(const SizingSpec& spec, const Surface& surface, const Shoeboxes& shoeboxes,
  const Meshlines& planes, Octants& octants, Execution& execution);

}
