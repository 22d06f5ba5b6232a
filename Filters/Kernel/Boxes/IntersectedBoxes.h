// SPDX-License-Identifier: BSD-3-Clause
// How many boxes the surface passes through.
#pragma once

#include "Boxes/Boxes.h"

namespace cartesian
{

double countIntersected(const PackedBox* begin, const PackedBox* end);

// Of all.
double countIntersected(const Boxes& boxes);

}
