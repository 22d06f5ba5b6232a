// SPDX-License-Identifier: BSD-3-Clause
// Boxes and patches made into a mesh, step by step (section 6: 9, A3, B1 to B4, 11 to 13).
#pragma once

#include "Cells/KeptParts.h"
#include "Cells/RemovedCell.h"
#include "Layers/BoundaryLayers.h"
#include "Mesh/OutputMesh.h"
#include "Mesher/Options.h"

#include <memory>

namespace cartesian
{

// What is not connected with the rest (KeptParts.h, Fragments.h).
struct SeparateParts
{
  std::size_t leftOut = 0;            // without a point to keep
  std::vector<RemovedCell> fragments; // cells of the core that went with small parts
  std::size_t isolatedCells = 0;      // cells of the core in those that stay
  std::vector<std::size_t>
    ofRegions; // how many there are in each (ConnectedCells.h); of the whole mesh only
};

// What happened to cells of the core.
struct CellEdits
{
  std::size_t split = 0; // cuts
  std::size_t merged = 0;
  std::vector<RemovedCell> removed; // by edits of the wall: small ones, and such as solvers refuse
  std::size_t simplified = 0; // they failed: faces were joined at any angle: the paper's IP patches
  std::vector<RemovedCell> overlapping; // they overlapped others as they were cut, and were removed
};

// The results of the steps for a part of the grid, or all of it. `mesh` refers to the others.
struct Assembly
{
  Boxes boxes;
  Patches patches;
  Sides sides;
  Nodes nodes;
  InnerFaces inner; // until cells are assembled of them and the patches
  WallMesh wall;
  std::vector<std::uint32_t> rebuilt; // boxes whose patches were rebuilt, in order
  CellEdits edits;
  SeparateParts separate;
  std::vector<std::uint32_t> overlapping; // boxes of cells that overlap others in the end
  double relaxation = 1;                  // of sizes, for the cell budget
  std::vector<double> regionVolumes;      // of cells of the core, by region, user units cubed
  std::unique_ptr<OutputMesh> mesh;
  std::unique_ptr<BoundaryLayers> layers; // on the mesh, or null
};

// The steps up to the cells as they are cut: `wall` can be opened for edits (Editing/WallOpening.h). Errors as of assemble().
std::unique_ptr<Assembly> cutCells(Boxes boxes, Patches patches, const Options& given,
  Execution& execution, const PartsToKeep& parts = {});

// Runs all steps. Throws Error: BadParameter, TooManyBoxes, FlawedSurface (no cell is left of the whole;
// a part may have none).
std::unique_ptr<Assembly> assemble(Boxes boxes, Patches patches, const Options& given,
  Execution& execution, const WallLayerSpec* layers = nullptr, const PartsToKeep& parts = {});

// How many cells of the core were left out for this reason after they were assembled: small ones that never became part of the
// wall are only marked (Cell::removed).
std::size_t countRemoved(const Assembly& assembly, RemovalReason reason);

// Boxes of the core whose patches were rebuilt (BoxRebuilding.h).
std::vector<std::uint32_t> rebuiltBoxes(const Assembly& assembly);

// Intersected boxes of the core without cells: neither their patches nor the rebuilt ones close.
std::vector<std::uint32_t> flawedBoxes(const Assembly& assembly);

}
