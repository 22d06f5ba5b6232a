// SPDX-License-Identifier: BSD-3-Clause
// Open surfaces around known places: what these can reach is the fluid (Repair/ReachedSpaces.h). So a surface need not be closed where
// the fluid is not, nor by itself: a vessel whose nozzle another file closes, blades that are there once, terrain.
//
// The places are the Keep Points. Without any, terrain that divides the domain box has the fluid on the side away from
// the ground, or, where there is none, on the side that its normals point to.
// Limits: holes narrower than the smallest box there are closed; where the fluid leaks through wider ones, the surface is
// repaired as bodies are (SurfaceRepair.h).
#pragma once

#include "Mesher/Options.h"

#include <optional>

namespace cartesian
{

struct PreparedSurface;

struct ReachedFluid
{
  std::size_t openEdges = 0;     // of the surface, before
  bool isKeptOutReached = false; // if it leaks, the surface ends a little beyond the grid

  // Of terrain without Keep Points, its boundary and the side of the box that it is seen from; none: NoSide.
  std::int32_t terrain = 0;
  DomainSide seenFrom = DomainSide::NoSide;
};

// Whether that needs the sides of the domain box (DomainBox.h), and so room around the grid.
bool mayNeedSides(const PreparedSurface& prepared, const Options& options, Execution& execution);

// Replaces the surface by the walls of the fluid. None, with nothing changed: it is closed, nothing says where the fluid
// is, or the fluid leaks out. Throws Error: as placesOnLattice() (KeepPoints.h); Leak (LeakPath.h): it reaches a point to keep
// out.
std::optional<ReachedFluid> reachFluid(
  PreparedSurface& prepared, const Options& options, Execution& execution);

}
