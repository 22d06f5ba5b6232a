// SPDX-License-Identifier: BSD-3-Clause
// Reads a STEP, IGES or BREP file: its solids and sheets, placed as the assembly says, in millimetres, with the names,
// colours and layers of their faces.
#pragma once

#include "CadOptions.h"
#include "CadPart.h"

namespace cartesian
{

struct CadFile
{
  std::vector<CadPart>
    parts; // solids first; then one part of all faces that belong to no solid, if there are any
  bool hasTopology = true; // false: faces do not know their neighbours (IGES)
};

// Throws CadError: the file cannot be read, or has neither solids nor faces.
CadFile readCadFile(const std::string& given, const CadOptions& options, const CadReport& report);

}
