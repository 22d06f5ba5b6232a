// SPDX-License-Identifier: BSD-3-Clause
// Makes one face of neighbours on one surface (planes, cylinders, ...) for which the file says the same.
#pragma once

#include "CadPart.h"

namespace cartesian
{

void mergeCoplanar(std::vector<CadPart>& parts, const CadReport& report);

}
