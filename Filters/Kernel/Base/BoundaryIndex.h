// SPDX-License-Identifier: BSD-3-Clause
// The number of the boundary that a face is of.
#pragma once

#include <cstdint>

namespace cartesian
{

// Boundary index of faces that do not come from the user's surface: at a leak, or at the end of the
// grid.
constexpr std::int32_t NoBoundary = -1;

}
