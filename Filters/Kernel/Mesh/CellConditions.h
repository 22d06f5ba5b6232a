// SPDX-License-Identifier: BSD-3-Clause
// How many cells miss the requirements of section 3: a part of the statistics of step 12.
#pragma once

#include "Cells/Boundary.h"

namespace cartesian
{

struct CellConditions
{
  std::size_t boundaryAngle = 0;  // cells with a boundary face at 90 degrees or more
  std::size_t innerAngle = 0;     // ... with an inner face at 75 or more
  std::size_t open = 0;           // face vectors that do not add up to 0 (equation 2): gaps
  std::size_t negativeVolume = 0; // or none at all
};

// Counts what QualityMeasures.h finds on the finished mesh. Hexahedra fulfil all of it.
CellConditions countFailures(const MeshParts& parts, const CellNumbers& numbers,
  const std::vector<BoundaryFace>& boundary, Execution& execution);

}
