// SPDX-License-Identifier: BSD-3-Clause
// Meshlines that would run along flat walls step to the side where they cut nothing off.
//
// By Dual Levels (section 4.2) a wall and a plane at the same coordinate are one level apart. If the wall
// lies beyond the plane, the domain between them is a flange a level thick on the boxes there, which no
// solver takes; two levels on, the plane is beyond the wall and there is none. Users like round numbers,
// and so do those who draw: this is common.
#pragma once

#include "Lattice/Meshlines.h"
#include "Surface/Surface.h"

namespace cartesian
{

// Each plane moves by two levels or stays, whichever leaves the smallest area of walls with a flange. Where the
// domain is around the surface, so do the first and the last, towards the middle: a body that stands on the
// ground stands in it.
// The surface is oriented.
void stepAside(const Surface& surface, Meshlines& planes);

}
