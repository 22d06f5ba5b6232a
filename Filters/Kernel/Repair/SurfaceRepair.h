// SPDX-License-Identifier: BSD-3-Clause
// Repairs a surface before it is meshed (steps 4 and 6): drops duplicate and loose triangles, gives sheets two sides,
// orients the rest, closes holes, and unites bodies that cross or touch.
//
// Method: combinatorial where triangles share vertices (Orientation.h, Holes.h); where bodies cross, exact predicates and iterated snap
// rounding on the lattice (Arrangement.h). Sources: Barequet and Sharir 1995 for holes by least area; Nooruddin and Turk 2003 for
// the votes of lines; CGAL's autorefinement of triangle soups for the rounds.
// Limits: holes at least as wide as a box are closed, and reported as leaks; how bodies were meant is not guessed, they become one;
// bodies whose cuts do not settle stay crossing and are named (refused). Nothing is repaired without a word.
#pragma once

#include "Repair/Duplicates.h"
#include "Repair/Holes.h"
#include "Repair/SurfaceCheck.h"
#include "Repair/ThinSheets.h"
#include "Repair/TrianglePairs.h"
#include "Repair/WallsOfBodies.h"

#include <memory>

namespace cartesian
{

struct SurfaceRepair
{
  std::vector<DroppedTriangle> sheets; // triangles of sheets, as they were before they got sides
  std::vector<DroppedTriangle> duplicates; // triangles already present, or a wall between bodies
  std::size_t turned = 0; // triangles that faced the other way than the domain's end
  SurfaceCheck check;     // oriented, without duplicates, before holes are closed
  std::vector<DroppedTriangle>
    loose;                 // triangles that share no edge with another: they enclose nothing
  std::vector<Hole> holes; // in order of their lowest vertices
  TrianglePairs pairs;     // that cross or overlap, with those that close holes
  std::shared_ptr<const Surface>
    crossing;                  // what the lists above are of; none: the surface, as it is now
  std::vector<Vector> refused; // where bodies cross that could not be united, levels
  std::vector<std::uint8_t> touching; // UnitedBodies::touching

  // Whether two that share a line belong to bodies that were united and only touch there.
  bool areTouching(const TrianglePair& pair) const;

  std::size_t leaks() const;
};

struct RepairSpec
{
  SheetHandling sheets = SheetHandling::Automatic;
  MeshedSide meshed = MeshedSide::Inside;
};

// Triangles that share no edge with another: they enclose nothing, and collapse into a point.
std::vector<DroppedTriangle> dropLoose(Surface& surface, const SurfaceEdges& edges);

// Afterwards every line enters each component as often as it leaves it, or at least crosses it an
// even number of times (Surface::byParity). Triangles keep their numbers: dropped ones collapse
// into a point, those that close holes are appended. A flawless surface whose normals point outward
// stays as it is.
SurfaceRepair closeAndOrient(
  Surface& surface, const Meshlines& planes, const RepairSpec& spec, Execution& execution);

// Does that, and cuts triangles that cross or overlap along each other (Arrangement.h): triangles with the inside on
// both sides are dropped, so that bodies are united.
SurfaceRepair repair(
  Surface& surface, const Meshlines& planes, const RepairSpec& spec, Execution& execution);

}
