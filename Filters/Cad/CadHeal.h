// SPDX-License-Identifier: BSD-3-Clause
// Sews faces together whose edges lie on each other, and makes solids of shells that are closed.
#pragma once

#include "CadFile.h"
#include "CadOptions.h"

namespace cartesian
{

// Solids with free edges are changed only with Heal Tolerance, or if the file says nothing about neighbours.
void heal(CadFile& file, const CadOptions& options, const CadReport& report);

}
