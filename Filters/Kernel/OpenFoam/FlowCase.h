// SPDX-License-Identifier: BSD-3-Clause
// A case of simpleFoam: steady incompressible flow, through a duct or around bodies.
#pragma once

#include "OpenFoam/CaseFiles.h"

namespace cartesian
{

void writeFlowCase(const SolverSetup& setup, const MeshOfCase& mesh,
  const std::optional<FlowAround>& around, int pieces, CaseFiles& files);

// A script that runs these commands, each to a log of its own, with -parallel if there are several pieces.
std::string scriptOf(const std::string& commands, int pieces);

// controlDict; `functions`: entries of function objects.
std::string controlOf(
  const std::string& application, const SolverSetup& setup, const std::string& functions);

std::string turbulenceProperties(const SolverSetup& setup);

}
