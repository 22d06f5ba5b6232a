// SPDX-License-Identifier: BSD-3-Clause
// Boxes and patches made into a mesh, step by step (section 6: 9, A3, B1 to B4, 11 to 13).
#pragma once

#include "Lifting/PrismStacks.h"
#include "Mesh/OutputMesh.h"
#include "Mesher/Options.h"
#include "Shaping/CellShaping.h"

#include <memory>

namespace cartesian
{

// What the steps have made of a part of the grid, or of all of it. `mesh` refers to the others.
struct Assembly
{
  Boxes boxes;
  Patches patches; // as rebuilding and the collapse of short edges left them
  Sides sides;
  Nodes nodes;
  InnerFaces inner;
  Cells cells;
  std::vector<std::uint8_t> rebuilt; // 1 for polyhedral boxes whose patches were made anew
  Shaping shaping;
  std::unique_ptr<OutputMesh> mesh;
  std::unique_ptr<PrismStacks> stacks; // on the mesh, or null: no layers
};

// Runs all steps. Throws Error: BadParameter, TooManyBoxes, FlawedSurface (no cell is left of the whole;
// a part may have none).
std::unique_ptr<Assembly> assemble(
  Boxes boxes, Patches patches, const Options& options, Execution& execution);

// How many boxes of the core have patches made anew (BoxRebuilding.h).
std::size_t rebuiltBoxes(const Assembly& assembly);

// Intersected boxes of the core that have no cells: neither their patches close nor those made anew.
std::vector<std::uint32_t> flawedBoxes(const Assembly& assembly);

}
