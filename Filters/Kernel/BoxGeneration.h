// Box Generation (section 4.5; steps 7 and 8).
#pragma once

#include "GlobalStatuses.h"
#include "Refinement.h"

namespace cartesian
{

// Every edge of the surface has an even number of triangles (SurfaceRepair.h): statuses come from the
// crossings along x. Global boxes that are intersected are divided to the
// depth allowed there into the fewest boxes that cover what is inside or intersected; forced depth
// divides them and inside boxes further. Then boxes are balanced (Balance.h).

// Layers of global boxes around a part of the grid that its cells depend on, directly or not. The
// cells of one layer beyond tell which points are used and which faces lost their neighbour; three
// times, flawed boxes change those around them, and are flawed by theirs (FlawedBoxes.h); faces
// between those and the next layer take the surface in one more, and how each box there is
// patched; and where boxes are divided, that takes the split lines of the next.
constexpr std::uint32_t HaloOfCells = 1;
constexpr std::uint32_t HaloOfRebuilding = 3 * 2;
constexpr std::uint32_t HaloOfUndivided = HaloOfCells + HaloOfRebuilding + 1;
constexpr std::uint32_t HaloOfDivided = HaloOfUndivided + 1;

// ... after balancing, which takes balanceReach() more.
inline std::uint32_t haloOf(const Refinement& refinement)
{
  return refinement.any() ? HaloOfDivided : HaloOfUndivided;
}

// The boxes of the layers `core` and of the halo around them, as far as the grid goes: those in the
// core and HaloOfCells layers around it have the same cells as in the whole grid.
//
// Throws Error (TooManyBoxes) where the mesh would take more bytes than `mostBytes`.
Boxes generateBoxes(const Surface& surface, const Meshlines& planes, const Shoeboxes& shoeboxes,
  const Refinement& refinement, const GlobalStatuses& statuses, Layers core, double mostBytes,
  Execution& execution);

// How large a mesh will be, roughly, before anything is built.
struct Estimate
{
  double inside = 0; // boxes
  double intersected = 0;
  double triangles = 0;

  double boxes() const { return inside + intersected; }
  double bytes() const;
};

// Without refinement.
Estimate estimateMesh(const Surface& surface, const Meshlines& planes);

// Of one global box.
Estimate estimateBox(BoxStatus status, const Depths& depths);

// Throws TooManyBoxes where the estimate exceeds `mostBytes`.
void checkMemory(const Estimate& estimate, double mostBytes);

}
