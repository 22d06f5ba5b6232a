// Cells made fit for solvers (sections 3, 4.10, 4.11): concave ones are split, small ones merged.
#pragma once

#include "Cells.h"

namespace cartesian
{

struct Shaping
{
  std::size_t cellsSplit = 0; // cuts
  std::size_t cellsMerged = 0;
  std::size_t cellsMended =
    0; // got a boundary face of several, of any angle: the paper's IP patches
  std::size_t partsCarved = 0; // that solvers refuse; removed
  std::size_t refusedCellsRemoved = 0;
};

// Whether there is anything to do.
bool shapesCells(const CellSpec& spec);

Shaping shapeCells(const Boxes& boxes, const Patches& patches, Sides& sides, Nodes& nodes,
  const InnerFaces& inner, Cells& cells, const CellSpec& spec, Execution& execution);

}
