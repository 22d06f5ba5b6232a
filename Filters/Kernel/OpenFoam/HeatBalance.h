// SPDX-License-Identifier: BSD-3-Clause
// How a case of chtMultiRegionSimpleFoam ends: when heat is in balance, or after as many iterations as it may take.
//
// One region after the other is solved, with what its neighbours gave it before, so that regions that conduct well take
// thousands of iterations to reach their temperatures, while residuals are small all the time. What tells is heat: what a
// solid takes in and gives off, and what the two regions on either side of an interface say of it.
#pragma once

#include "OpenFoam/CaseFiles.h"

namespace cartesian
{

// After this many iterations heat is looked at, or after all if they are fewer.
int heatInterval(const SolverSetup& setup);

// Entries of controlDict, which write the heat through each patch of each region at these intervals.
std::string heatFunctions(
  const SolverSetup& setup, const std::vector<MeshOfCase>& meshes, const CaseFiles& files);

// Commands of Allrun, which run the solver until heat is in balance and then say so, or what is not.
// Debian's OpenFOAM lets the administrator make no system calls, so no function object can compare: each run ends at an
// interval, and the script looks.
std::string heatCommands(
  const SolverSetup& setup, const std::vector<MeshOfCase>& meshes, const CaseFiles& files);

}
