// SPDX-License-Identifier: BSD-3-Clause
// A case of simpleFoam: steady incompressible flow, through a duct or around bodies.
#pragma once

#include "OpenFoam/CaseFiles.h"

namespace cartesian
{

void writeFlowCase(const SolverSetup& setup, const MeshOfCase& mesh,
  const std::optional<FlowAround>& around, CaseFiles& files);

std::string turbulenceProperties(const SolverSetup& setup, const CaseFiles& files);

}
