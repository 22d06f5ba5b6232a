// SPDX-License-Identifier: BSD-3-Clause
// User options for the shape of cells (sections 4.10, 4.11).
#pragma once

#include "Base/Range.h"

namespace cartesian
{

struct CellShapeSpec
{
  static constexpr Range MergeRatios{ 0, 1, false };
  static constexpr Range RefusedCellRatios{ 0 };

  // Where small cells merge, those below this part of their box's volume do.
  double mergeRatio = 0.3;

  // Those that no neighbour can absorb, and that strain solvers, are removed below this part of their box: R (4.10)
  // where cells merge.
  double strandedRatio() const { return mergeRatio / 10; }

  // Whether nodes at the wall move to within preferred quality limits (NodeMoves.h, WallCentring.h); not with Exact Fit.
  bool optimiseNodes = true;

  // Whether nodes of curved walls move off the surface, so that the mesh has its volume (TrueVolume.h); not with Exact Fit,
  // nor where cells stay as they are cut.
  bool trueVolume = true;

  bool splitConcave = true; // cells that fail an angle condition of section 3

  // Whether cells that still fail, up to a tenth of their box, and small ones that no neighbour can take are removed; 0: none.
  // How far above 0 it is makes no difference any more.
  double refusedCellRatio = 4;
};

}
