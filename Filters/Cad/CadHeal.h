// SPDX-License-Identifier: BSD-3-Clause
// Sews faces together whose edges lie on each other, and makes solids of shells that are closed.
#pragma once

#include "CadFile.h"
#include "CadOptions.h"

namespace cartesian
{

// Changes parts with free edges only: with Heal Tolerance, or where the file says nothing about neighbours.
void heal(CadFile& file, const CadOptions& options, const CadReport& report);

}
