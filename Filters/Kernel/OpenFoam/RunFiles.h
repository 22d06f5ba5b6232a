// SPDX-License-Identifier: BSD-3-Clause
// How a case runs: its controlDict, and the script Allrun.
#pragma once

#include "OpenFoam/SolverSetup.h"

#include <string>
#include <utility>
#include <vector>

namespace cartesian
{

struct SolverRun
{
  std::string application;
  int last;            // iteration
  int interval;        // between those that are written
  bool isPart = false; // it begins with what was written last, and ends where it writes next
};

// controlDict; `functions`: entries of function objects.
std::string controlOf(const SolverRun& run, const std::string& functions);

// A script that runs these commands with -parallel if there are several pieces: "run PROGRAM" with its own log, "more
// PROGRAM" another time with the same.
std::string scriptOf(const std::string& commands, int pieces);

// A text with each of these names replaced by its value, in order.
std::string filledIn(
  std::string text, const std::vector<std::pair<std::string, std::string>>& values);

}
