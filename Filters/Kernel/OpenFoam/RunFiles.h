// SPDX-License-Identifier: BSD-3-Clause
// How a case runs: its controlDict, and the script Allrun.
#pragma once

#include "OpenFoam/SolverSetup.h"

#include <string>

namespace cartesian
{

// controlDict; `functions`: entries of function objects.
std::string controlOf(
  const std::string& application, const SolverSetup& setup, const std::string& functions);

// A script that runs these commands, each with its own log, with -parallel if there are several pieces.
std::string scriptOf(const std::string& commands, int pieces);

}
