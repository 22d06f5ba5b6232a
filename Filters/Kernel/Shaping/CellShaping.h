// SPDX-License-Identifier: BSD-3-Clause
// Cells made fit for solvers (sections 3, 4.10, 4.11): concave ones are split, small ones merged.
// Slab by slab (Slabs.h): those of the core, and around it what a point of theirs may belong to.
#pragma once

#include "Cells/Cells.h"
#include "Shaping/ShapingSpec.h"

namespace cartesian
{

// Of a part of a mesh, what happened to cells of its core.
struct Shaping
{
  std::size_t cellsSplit = 0; // cuts
  std::size_t cellsMerged = 0;
  std::size_t cellsMended =
    0; // got a boundary face of several, of any angle: the paper's IP patches
  std::size_t partsCarved = 0; // that solvers refuse; removed
  std::size_t refusedCellsRemoved = 0;
};

Shaping operator+(Shaping sum, const Shaping& other);

// Whether there is anything to do.
bool shapesCells(const SmallCellSpec& small, const ShapingSpec& spec);

Shaping shapeCells(const Boxes& boxes, const Patches& patches, Sides& sides, Nodes& nodes,
  const InnerFaces& inner, Cells& cells, const SmallCellSpec& small, const ShapingSpec& spec,
  double featureAngle, Execution& execution);

}
