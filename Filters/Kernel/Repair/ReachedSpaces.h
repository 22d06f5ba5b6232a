// SPDX-License-Identifier: BSD-3-Clause
// What can be reached from given places is the fluid: its walls are all that is next to it, whichever way that faces, and
// whether or not it is closed by itself. What is open elsewhere does not matter; what has the fluid on both sides is a
// sheet.
//
// Method: triangles are cut along each other (Arrangement.h); then it is known which of their sides are next to the same space
// (JoinedSides.h). Exact: nothing depends on boxes.
// Limits: a gap of a rim that is wider than the lattice resolves is open, unless it was closed before (Cracks.h, RimsOnWalls.h,
// ClosedGaps.h).
#pragma once

#include "Repair/Baffles.h"

#include <optional>

namespace cartesian
{

// Where the fluid is known to be.
struct ReachSpec
{
  std::vector<Point> points;                 // even levels, on no triangle
  std::vector<std::optional<Point>> keepOut; // the same; none: far away
  std::vector<Baffle> baffles;

  // From here on triangles are the sides of the domain box, with normals that point out of it (DomainBox.h): no walls, and what is
  // outside of them is as the fluid. None: there is no box.
  std::optional<std::size_t> firstOfBox;
  std::optional<std::size_t>
    seenFrom; // a triangle of the box: the largest part of it has fluid behind it
};

struct Reach
{
  bool hasWalls = false;                   // else the surface is as it was
  std::optional<std::size_t> keptOut = {}; // the first one that is reached; then there are no walls
  std::optional<std::size_t> from = {};    // the first of the points that reach it
};

// Replaces the surface by the walls around what is reached, with normals that point out of it, or into it where there
// is a box; and by sheets, which get sides (ThinSheets.h). No walls: what is reached goes on for ever, has none, or triangles do
// not settle.
Reach keepReached(Surface& surface, const ReachSpec& spec, Execution& execution);

}
