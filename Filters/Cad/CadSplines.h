// SPDX-License-Identifier: BSD-3-Clause
// Parts again with B-splines as surfaces: Open CASCADE triangulates some faces only so.
#pragma once

#include "CadPart.h"

namespace cartesian
{

// Those that are marked and what shares faces with them, the others as they are. Faces stay in order; empty if Open CASCADE cannot.
std::vector<CadPart> asSplines(const std::vector<CadPart>& parts, std::vector<bool> marked);

}
