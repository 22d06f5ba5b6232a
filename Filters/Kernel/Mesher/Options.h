// SPDX-License-Identifier: BSD-3-Clause
// All user options: each with its default, range and unit once, here or in its group. The panel's names for them are in
// OptionTable.h.
#pragma once

#include "Boxes/MeshEstimate.h"
#include "Boxes/Refinement.h"
#include "Cells/SmallCellSpec.h"
#include "Editing/CellShapeSpec.h"
#include "Editing/ShortEdgeSpec.h"
#include "Lattice/Meshlines.h"
#include "Patches/PatchSpec.h"
#include "Repair/Baffles.h"
#include "Repair/Cracks.h"
#include "Repair/ThinSheets.h"
#include "Surface/FlowDomain.h"
#include "Surface/WallLayerSpec.h"

namespace cartesian
{

// What the caller makes SurfaceView::region of.
enum class RegionSource : std::uint8_t
{
  One = 0,    // there is one region
  Blocks = 1, // each block of the surface is one
  Array = 2,  // by a cell array
};

struct Options
{
  static constexpr Range MemoryLimits{ 0 };
  static constexpr Range CellBudgets{ 0 };
  static constexpr Range GapWidths{ 0 };

  RegionSource regionsFrom = RegionSource::One;
  int depthAtSurface =
    0; // how often boxes there may be halved, beside what `refinement` says of it
  CrackSpec cracks;
  double closeGaps = 0;        // user units (ClosedGaps.h)
  double contactTolerance = 0; // user units (Regions.h)
  SheetHandling sheets = SheetHandling::Automatic;
  std::vector<Baffle> baffles;
  std::vector<std::int32_t> zones; // boundaries that enclose zones of the domain Outside (Zones.h)
  DomainSpec domain;
  GridSpec grid;
  RefinementSpec refinement;
  PatchSpec patches; // with the feature angle of all steps
  ShortEdgeSpec collapse;
  SmallCellSpec smallCells;
  CellShapeSpec shaping;
  WallLayerSpec layers;

  // The most cells: refinement.sizing, except its feature depth, is relaxed until they fit (CellBudget.h); 0: any
  // number.
  double cellBudget = 0;

  // GiB that the mesh, or each part of it, may need by an estimate; 0: three quarters of this
  // machine's memory.
  double memoryLimit = 0;
};

// The memory that a mesh may take; unlimited if this machine's memory is unknown.
MemoryLimit memoryLimitOf(const Options& options, int threads);

// Whether the cells at the wall are edited (Editing/WallImprovement.h), or stay as they are cut.
bool editsWall(const Options& options);

// Boxes that double in size right at a wall smear separating flow, so outside there are 3 layers between, unless the
// user says otherwise.
int transitionLayersOf(const Options& options);

// Whether nodes rise from the surface until the mesh has its volume (Editing/TrueVolume.h).
bool keepsTrueVolume(const Options& options);

// Whether cells are merged or cut, not only short edges collapse.
bool shapesCells(const Options& options);

// Throws Error (BadParameter) where an option about cells is out of its range; other groups are checked
// by the rooms that take them.
void requireValidCells(const Options& options);

}
