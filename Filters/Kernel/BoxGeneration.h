// Box Generation (section 4.5; steps 7 and 8).
#pragma once

#include "Boxes.h"
#include "Refinement.h"
#include "Shoeboxes.h"
#include "Surface.h"

namespace cartesian
{

// Every edge of the surface has an even number of triangles (SurfaceRepair.h): statuses come from the
// crossings along x. Global boxes that are intersected are divided to the
// depth allowed there into the fewest boxes that cover what is inside or intersected; forced depth
// divides them and inside boxes further. Then boxes are balanced (Balance.h).
//
// Throws Error (TooManyBoxes) where the mesh would take more bytes than `mostBytes`.
Boxes generateBoxes(const Surface& surface, const Meshlines& planes, const Shoeboxes& shoeboxes,
  const Refinement& refinement, double mostBytes, Execution& execution);

// How many boxes and bytes the mesh will take, roughly, before anything is built and without
// refinement.
struct Estimate
{
  double boxes;
  double bytes;
};
Estimate estimateMesh(const Surface& surface, const Meshlines& planes);

// Throws TooManyBoxes where the estimate exceeds `mostBytes`.
void checkMemory(const Estimate& estimate, double mostBytes);

}
