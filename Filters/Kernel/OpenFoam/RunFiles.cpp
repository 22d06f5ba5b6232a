// SPDX-License-Identifier: BSD-3-Clause
#include "OpenFoam/RunFiles.h"

namespace cartesian
{

std::string controlOf(
  const std::string& application, const SolverSetup& setup, const std::string& functions)
{
  const std::string last = std::to_string(setup.iterations);
  return "application     " + application +
    ";\nstartFrom       startTime;\nstartTime       0;\nstopAt          endTime;\nendTime        "
    " " +
    last + ";\ndeltaT          1;\nwriteControl    timeStep;\nwriteInterval   " + last +
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
    (pieces > 1 ? parallel : "\"$@\"") + R"foam( > "log.$1" 2>&1
}
run()
{
  echo "$1"
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

}
