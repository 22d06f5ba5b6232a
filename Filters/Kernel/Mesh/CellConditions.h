// SPDX-License-Identifier: BSD-3-Clause
// Counts the cells that fail the conditions of section 3, for the statistics of step 12.
#pragma once

#include "Cells/Boundary.h"

namespace cartesian
{

struct CellConditions
{
  std::size_t boundaryAngle = 0;  // cells with a boundary face at 90 degrees or more
  std::size_t innerAngle = 0;     // ... with an inner face at 75 degrees or more
  std::size_t open = 0;           // whose face vectors do not add up to 0 (equation 2): gaps
  std::size_t negativeVolume = 0; // or zero
};

// The same failures as QualityMeasures.h finds in the finished mesh. Hexahedra fulfil all conditions.
CellConditions countFailures(
  const MeshParts& parts, const CellNumbers& numbers, Execution& execution);

}
