// SPDX-License-Identifier: BSD-3-Clause
// What drives the flow between periodic sides, where there is no inlet: a force that keeps the mean velocity.
#pragma once

#include "OpenFoam/CaseFiles.h"

namespace cartesian
{

// Its direction, of length 1: from the first side of the first pair to the second, if one is the other moved; none: there is no
// such pair, or there are inlets.
std::optional<Vector> drivenAlong(const MeshOfCase& mesh, const std::optional<FlowAround>& around);

// constant/fvOptions, if the flow is driven.
void writeDrive(const SolverSetup& setup, const MeshOfCase& mesh,
  const std::optional<FlowAround>& around, CaseFiles& files);

}
