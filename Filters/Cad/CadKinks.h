// SPDX-License-Identifier: BSD-3-Clause
// Divides faces along the kinks inside them, which some modellers write: else they are no edges.
#pragma once

#include "CadOptions.h"
#include "CadPart.h"

namespace cartesian
{

// A part whose triangles close only undivided stays as it is.
void divideAtKinks(std::vector<CadPart>& parts, const CadOptions& options, const CadReport& report);

}
