// SPDX-License-Identifier: BSD-3-Clause
// Whether a user's rows of conditions fit the meshes and the solver.
#pragma once

#include "OpenFoam/SolverSetup.h"

namespace cartesian
{

// Throws Error (BadParameter), which names the patch: a row for no patch, two for one, values out of range, or that a patch
// of this kind, or this solver, does not have; or no patch of a fluid region is left at a pressure.
void requireSuitableConditions(const SolverSetup& setup, const std::vector<MeshOfCase>& meshes,
  const std::optional<FlowAround>& around);

}
