// SPDX-License-Identifier: BSD-3-Clause
// The whole meshing task, step by step (section 6): what the filters run.
//
//   surface --prepareSurface--> Surface, Meshlines     steps 2, 3, 4
//           --decompose-------> Decomposition, Boxes   steps 5, 7, 8   (Cartesian Boxer)
//           --makePatches-----> Patches                A1              (Patcher)
//           --assemble--------> Sides, InnerFaces,     9, A3, B1-B4    (Cell Assembler)
//                               Cells, OutputMesh      11-13
//
// mesh() is all of it, meshPart() all that follows decompose() for one part of the grid.
//
// Method: boxes of a grid are halved where the surface asks for it, cut by it, and what is left of them is edited at the wall until
// solvers accept it. Source: L. Placek's paper (the room's README says which section is where); what it does not have is marked
// there as beyond it. The mesh does not depend on threads or parts.
// Limits: a surface with an inside; 32 bits for numbers of boxes, cells and points of a part; coordinates are rounded to a lattice
// of 2^32 levels along the longest side. Detail below a box is simplified, unless Exact Fit is chosen.
#pragma once

#include "Mesher/Assembly.h"
#include "Mesher/Options.h"
#include "Mesher/ReachedFluid.h"
#include "Mesher/Stages.h"
#include "Parts/Decomposition.h"
#include "Repair/Contacts.h"
#include "Repair/OpenSheets.h"
#include "Repair/SurfaceRepair.h"
#include "Surface/KeepPoints.h"

#include <map>
#include <memory>
#include <optional>
#include <string>

namespace cartesian
{

// The mesh of everything that the surface encloses. Throws Error: what the steps below throw.
std::unique_ptr<Assembly> mesh(
  const SurfaceView& surface, const Options& options, Execution& execution);

struct PreparedSurface
{
  Surface surface;
  std::map<std::int32_t, std::size_t> boundariesGiven; // how many of the user's triangles each has
  JoinedCracks cracks;
  SurfaceRepair repair;
  OpenSheets openSheets;
  std::optional<ReachedFluid> fluid;   // none: the surface was repaired as bodies are
  std::vector<ClosedContact> contacts; // of several regions
  Meshlines planes;
  Bounds bounds;        // of the surface, user units
  bool hasRoom = false; // around the grid, for the sides of the domain box (DomainBox.h)
  std::vector<KeepPoint> keepPoints;
  std::vector<KeepPoint> keepOut;
  bool isEnclosed = false; // the surface must enclose the space around each
  MemoryLimit memoryLimit;

  // The user's triangles, repaired, for messages.
  const Surface& inspected() const { return repair.crossing ? *repair.crossing : surface; }

  // Of these the user's; what follows closes holes.
  std::size_t trianglesGiven() const { return inspected().given.size(); }
};

// Scaling, Dual Levels, check and repair of the surface. `parts`: how many the mesh is made in, each of which
// may take as much memory as the options allow. Throws Error: EmptySurface, BadCoordinate,
// BadCellSize, BadMeshlines, TooManyBoxes.
PreparedSurface prepareSurface(
  const SurfaceView& view, const Options& options, Execution& execution, int parts = 1);

// The same without check and repair, which takes a fraction of the time: the surface is neither oriented nor closed.
// Throws Error: as prepareSurface().
PreparedSurface placeOnGrid(
  const SurfaceView& view, const Options& options, Execution& execution, int parts = 1);

// The same with cracks joined and open sheets found, before the rest of check and repair.
PreparedSurface joinSurface(
  const SurfaceView& view, const Options& options, Execution& execution, int parts = 1);

// Of the smallest boxes, where global ones are halved so often; in levels.
double smallestBoxSide(const PreparedSurface& prepared, int depth);

// How often boxes at the surface may be halved.
int depthAtSurface(const Options& options);

// How prepareSurface() repairs a surface of one region.
RepairSpec repairOf(const Options& options);

// All that refines the grid. `longestSide`: of the surface, in user units, by which layers are found; without it only the
// deepest depths are right.
RefinementSpec refinementOf(const Options& options, double longestSide = 0);

// How the grid is divided; borrows `prepared`. Throws Error: BadParameter (of the refinement); of a
// region's surface EmptySurface, BadCoordinate, FlawedSurface.
std::unique_ptr<Decomposition> decompose(
  const PreparedSurface& prepared, const Options& options, Execution& execution);

// Throws Error: BadParameter (an angle).
Patches makePatches(const PreparedSurface& prepared, const Decomposition& decomposition,
  const Boxes& boxes, const Options& options, Execution& execution);

// The boxes, patches and cells of one part: the layers `core` of global boxes. Throws Error:
// TooManyBoxes, BadParameter, FlawedSurface.
std::unique_ptr<Assembly> meshPart(const PreparedSurface& prepared,
  const Decomposition& decomposition, SlabRange core, const Options& options, Execution& execution);

}
