// SPDX-License-Identifier: BSD-3-Clause
// Improves cells for solvers (sections 3, 4.10, 4.11): concave ones are split, small ones merged. Slab by slab
// (Slabs.h): those of the core, and around it what a point of theirs may belong to.
#pragma once

#include "Cells/SmallCellSpec.h"
#include "Cells/WallMesh.h"
#include "Shaping/RemovedCell.h"
#include "Shaping/ShapingSpec.h"
#include "Surface/WallLayerSpec.h"

namespace cartesian
{

// Of a part of a mesh, what happened to cells of its core.
struct Shaping
{
  std::size_t cellsSplit = 0; // cuts
  std::size_t cellsMerged = 0;
  std::size_t cellsRemoved = 0; // small ones, by edits in place
  std::size_t cellsSimplified =
    0; // they failed: faces are joined at any angle: the paper's IP patches
  std::vector<RemovedCell> refused; // and removed
  bool isAnyRefused = false;        // and still there, of a slab
};

Shaping operator+(Shaping sum, const Shaping& other);

// Whether there is anything to do.
bool shapesCells(const SmallCellSpec& small, const ShapingSpec& spec);

struct ShapingTask
{
  const SmallCellSpec& small;
  const ShapingSpec& spec;
  double featureAngle;         // degrees; edges of the wall that turn by more than this stay
  const WallLayerSpec* layers; // that some walls will have, or null
  bool isAround;               // the space around bodies is meshed, in a box
};

Shaping shapeCells(const Boxes& boxes, const Patches& patches, Sides& sides, Nodes& nodes,
  WallMesh& mesh, const ShapingTask& task, Execution& execution);

}
