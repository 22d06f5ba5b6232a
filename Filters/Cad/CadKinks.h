// SPDX-License-Identifier: BSD-3-Clause
// Divides faces along the kinks inside them, which some modellers write: else they are no edges.
#pragma once

#include "CadPart.h"

namespace cartesian
{

void divideAtKinks(std::vector<CadPart>& parts, const CadReport& report);

}
