// SPDX-License-Identifier: BSD-3-Clause
// Volume-true walls (beyond the paper). Patches of Marching Cubes are chords of the surface, which lie inside of it where
// it is convex; their nodes move off the surface by as much as lets the patches of each box enclose what the surface
// encloses there (Patches::missing): on a circle by two thirds of the sagitta, so the largest distance falls, too.
#pragma once

#include "Faces/InnerFaces.h"
#include "Faces/Nodes.h"

namespace cartesian
{

// Along the normal, once edges have collapsed. Nodes where the wall turns by more than `featureAngle` (degrees) or several
// boundaries meet stay, and so do those among flat patches alone (where a flat wall becomes a curved one without an edge,
// its last nodes go part of the way); towards nodes that stay, the others' way becomes shorter. Nodes on the grid's ends
// stay there. Returns whether any moved; then cells are to be made anew.
bool standOff(const Boxes& boxes, const Patches& patches, const InnerFaces& inner,
  double featureAngle, Nodes& nodes, Execution& execution);

}
