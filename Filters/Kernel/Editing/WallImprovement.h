// SPDX-License-Identifier: BSD-3-Clause
// The wall, from raw cells to ones that solvers take: simplified, short edges snapped, then the loop, first in general, then
// for what still fails, and last the volume made true.
//
// Method: greedy local search. An edit of a few kinds (PrimitiveEdits.h) is made if EditDecision.h allows it and the objective
// (WallObjective.h) falls; if not, the journal takes it back bit for bit. Blocks are edited at the same time (EditBlocks.h).
// Sources: sections 3, 4.10 and 4.11 for what is wrong with cells; edge collapse as Hoppe 1996 has it; the order by cost and the
// charges for walls and edges are ours.
// Limits: a local minimum, not the best mesh; faces that no edit helps stay and are told; walls move by no more than a hundredth of
// a box for a face that is just within the preferred limits. All wall cells near to each other are edited by one thread.
#pragma once

#include "Cells/SmallCellSpec.h"
#include "Editing/EditLoop.h"

namespace cartesian
{

struct ImprovementSpec
{
  double collapseRatio = 0.1; // 0: no edge goes for its length alone
  double smallShare = 0.3;    // of its box: where a cell is small
  SmallCellSpec small;    // cells below its ratios go at any cost: into a neighbour, if they merge
  bool cuts = true;       // concave cells; and joins walls of failing ones at any angle
  bool movesNodes = true; // also for what faces and cells cost
  bool trueVolume = true; // nodes rise until the mesh has the volume of the surface
  bool removesCells = true;   // small ones, where nothing else helps
  bool mayChangeWalls = true; // false: they stay as they are

  bool merges() const { return small.handling == SmallCells::Merge; }
  bool improves() const { return merges() || cuts; } // else only short edges go
};

// Faces and cells are measured (EditMeasures.h). Returns what was done to cells, by boxes.
std::vector<MadeEdit> improveWall(
  MeshEditor& mesh, const ImprovementSpec& spec, Execution& execution);

}
