// SPDX-License-Identifier: BSD-3-Clause
// What is said of gaps that were closed, and where they are.
#pragma once

#include "Mesher/ClosedGaps.h"
#include "Repair/SurfaceDefects.h"
#include "Surface/Surface.h"

#include <cstddef>
#include <string>

namespace cartesian
{

// The name of its boundary; gaps are numbered from 0.
std::string nameOfGap(std::ptrdiff_t gap);

// A message about gaps and panes; empty if there are none. `surface`: with the points of gaps.
std::string describe(const ClosedGaps& closed, const SurfaceView& surface);

// Adds gaps to the defects, as their last kind.
void list(const ClosedGaps& closed, const SurfaceView& surface, SurfaceDefects& defects);

}
