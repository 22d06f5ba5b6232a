// SPDX-License-Identifier: BSD-3-Clause
// Runs read-cad (Filters/Cad), which reads a CAD file in a process of its own.
#pragma once

#include "Stream.h"

#include <functional>
#include <string>
#include <vector>

namespace cartesian
{

class Execution;

struct CadContent
{
  std::vector<std::string> boundaries; // names, by number
  std::vector<CadSolid> solids;
  std::vector<std::string> notes;    // what was found and done
  std::vector<std::string> warnings; // what the user must know
};

// Where the program is installed: beside this library.
std::string cadProgram();

// `arguments`: as the program wants them. `timeLimit`: in seconds, 0 for none. Throws Error (CannotRead): there is no such
// program, or it refuses the file, crashes, or takes longer; Stopped.
CadContent runCadProgram(
  const std::vector<std::string>& arguments, double timeLimit, Execution& execution);

}
