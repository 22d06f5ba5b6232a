// SPDX-License-Identifier: BSD-3-Clause
#include "OpenFoam/RunFiles.h"

namespace cartesian
{

std::string controlOf(const SolverRun& run, const std::string& functions)
{
  return "application     " + run.application + ";\nstartFrom       " +
    (run.isPart ? "latestTime" : "startTime") + ";\nstartTime       0;\nstopAt          " +
    (run.isPart ? "nextWrite" : "endTime") + ";\nendTime         " + std::to_string(run.last) +
    ";\ndeltaT          1;\nwriteControl    timeStep;\nwriteInterval   " +
    std::to_string(run.interval) +
    ";\npurgeWrite      2;\nwriteFormat     ascii;\nwritePrecision  12;\n"
    "runTimeModifiable true;\n\nfunctions\n{\n" +
    functions + "}\n";
}

std::string scriptOf(const std::string& commands, int pieces)
{
  const std::string parallel = "mpirun -n " + std::to_string(pieces) + " \"$@\" -parallel";
  return R"foam(#!/bin/sh
# Runs the case; each program writes its own log.
set -eu
cd "$(dirname "$0")"
export WM_PROJECT_DIR="${WM_PROJECT_DIR:-/usr/share/openfoam}" # where Debian has it
start()
{
  )foam" +
    (pieces > 1 ? parallel : "\"$@\"") + R"foam( >> "log.$1" 2>&1
}
run()
{
  echo "$1"
  : > "log.$1"
  more "$@"
}
more()
{
  start "$@" && return
  if grep -q 'IOstream "sha1"' "log.$1"; then
    echo "$1 without function objects, of which the OpenFOAM of Debian 13 dies"
    start "$@" -noFunctionObjects && return
  fi
  tail "log.$1"
  exit 1
}
)foam" +
    commands;
}

std::string filledIn(
  std::string text, const std::vector<std::pair<std::string, std::string>>& values)
{
  for (const auto& [name, value] : values)
  {
    for (std::size_t at = text.find(name); at != std::string::npos;
         at = text.find(name, at + value.size()))
    {
      text.replace(at, name.size(), value);
    }
  }
  return text;
}

}
