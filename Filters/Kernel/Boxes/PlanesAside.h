// SPDX-License-Identifier: BSD-3-Clause
// Planes that would run along flat walls step to the side where they cut nothing off.
//
// By Dual Levels (section 4.2) a wall and a plane at the same coordinate are a level apart, or more where a file
// holds the coordinate in single precision. If the wall lies beyond the plane, the domain between them is a flange
// a few levels thick on the boxes there, which no solver takes; if the plane is beyond the wall there is none.
// Users like round numbers, and so do those who draw: this is common.
#pragma once

#include "Boxes/Boxes.h"
#include "Surface/Surface.h"

namespace cartesian
{

// Each meshline, and each plane that may divide boxes, steps past the walls that it would run along, or stays:
// whichever leaves the smallest area of walls with a flange. Where the domain is around the surface, so do the first
// and the last meshline, towards the middle: a body that stands on the ground stands in it.
// The surface is oriented.
void stepAside(const Surface& surface, Meshlines& planes);

}
