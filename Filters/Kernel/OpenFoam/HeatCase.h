// SPDX-License-Identifier: BSD-3-Clause
// A case of chtMultiRegionSimpleFoam: heat carried by the steady flow through fluid regions, and conducted in solid ones.
#pragma once

#include "OpenFoam/CaseFiles.h"

namespace cartesian
{

// Without rows of materials, the fluid is air, the solid steel; without rows of conditions, outer walls of solids are cooled by the air around them. The density of the fluid is
// constant, so its flow does not depend on temperatures: it is a case of simpleFoam (FlowCase.h) in flow/<region>, whose
// result the script Allrun passes on. Then heat is iterated until it is in balance (HeatBalance.h). (In Debian's OpenFOAM 1912 chtMultiRegionSimpleFoam's own flow is wrong in small
// cells, as potentialFoam's velocity is.)
void writeHeatCase(
  const SolverSetup& setup, const std::vector<MeshOfCase>& meshes, int pieces, CaseFiles& files);

}
