// SPDX-License-Identifier: BSD-3-Clause
// True Volume (beyond the paper). Patches of Marching Cubes are chords of the surface, which lie inside of it where it
// is convex; their nodes move off the surface until the patches of each box enclose the surface's volume there
// (Patches::missing): on a circle by two thirds of the sagitta, so the largest distance falls, too.
#pragma once

#include "Faces/InnerFaces.h"
#include "Faces/Nodes.h"

namespace cartesian
{

// Along the normal, once edges have collapsed. Nodes where the wall turns by more than `featureAngle` (degrees) or
// several boundaries meet stay, and so do those among flat patches alone (where a flat wall blends into a curved one,
// its last nodes go part of the way); towards nodes that stay, the others move less. Nodes on the grid's ends stay
// there. Returns whether any moved; then cells must be rebuilt.
bool standOff(const Boxes& boxes, const Patches& patches, const InnerFaces& inner,
  double featureAngle, Nodes& nodes, Execution& execution);

}
