// SPDX-License-Identifier: BSD-3-Clause
// Moves planes that would run along walls to the side where they cut nothing off.
//
// By Dual Levels (section 4.2) a wall and a plane at the same coordinate are a level apart, or more where a file
// holds the coordinate in single precision. If the wall lies beyond the plane, the domain between them is a flange a
// few levels thick on the boxes there, which no solver accepts; if the plane is beyond the wall there is none. Users
// and CAD models prefer round numbers, so this is common.
//
// Curved walls that are tangent to a plane, nearer than points of patches may be (PlaneClearance.h), would leave slivers
// as thick as that (Peaks.h). The plane then moves so far that none is as near: at most by twice that clearance, some
// millionths of a box, and to the side where it cuts off no caps if it can.
#pragma once

#include "Base/Execution.h"
#include "Boxes/Boxes.h"
#include "Surface/Surface.h"

namespace cartesian
{

// Each meshline, and each plane that may divide boxes, moves past the walls that it would run along, or stays:
// whichever leaves the smallest area of walls with a flange. In external domains so do the first and the last
// meshline, towards the middle: a body that stands on the ground then stands in it, and one that was cut there ends
// there, though its corners are not quite on the plane. The surface is oriented.
// `depth`: the largest that is asked for; it becomes the level of the planes.
void stepAside(const Surface& surface, int depth, Meshlines& planes, Execution& execution);

}
