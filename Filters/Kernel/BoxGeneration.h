// Box Generation (section 4.5; steps 7 and 8).
#pragma once

#include "GlobalStatuses.h"
#include "Refinement.h"
#include "Slabs.h"

namespace cartesian
{

// Every edge of the surface has an even number of triangles (SurfaceRepair.h): statuses come from the
// crossings along x. Global boxes that are intersected are divided to the
// depth allowed there into the fewest boxes that cover what is inside or intersected; forced depth
// divides them and inside boxes further. Then boxes are balanced (Balance.h).

// Layers of global boxes around a part of the grid that its cells depend on, directly or not. What
// happens to cells once they are cut reaches as far as cutFrom() says (Slabs.h). Before, three times,
// flawed boxes change those around them, and are flawed by theirs (FlawedBoxes.h); faces between those
// and the next layer take the surface in one more, and how each box there is patched; and where boxes
// are divided, that takes the split lines of the next.
constexpr std::uint32_t HaloOfRebuilding = 3 * 2;
constexpr std::uint32_t HaloOfUndivided = HaloOfRebuilding + 1;
constexpr std::uint32_t HaloOfDivided = HaloOfUndivided + 1;

// ... after balancing, which takes balanceReach() more.
inline Layers layersFor(
  Layers core, const Reach& reach, const Refinement& refinement, std::uint32_t allLayers)
{
  return cutFrom(core, reach, allLayers)
    .grown(refinement.any() ? HaloOfDivided : HaloOfUndivided, allLayers);
}

// The boxes of the layers `core` and of those around it that it depends on.
//
// Throws Error (TooManyBoxes) where the mesh would take more bytes than `mostBytes`.
Boxes generateBoxes(const Surface& surface, const Meshlines& planes, const Shoeboxes& shoeboxes,
  const Refinement& refinement, const GlobalStatuses& statuses, Layers core, const Reach& reach,
  double mostBytes, Execution& execution);

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
