// SPDX-License-Identifier: BSD-3-Clause
// About how many boxes there will be, of several sizes, before anything is meshed.
#pragma once

#include "Base/Execution.h"
#include "Mesher/Options.h"
#include "Surface/Surface.h"

#include <array>

namespace cartesian
{

// Of the grid and with all refinement that the options ask for. Where only areas of the surface matter, they tell; else
// each box of the grid is looked at, or some of its layers, unless there are far too many. Throws Error: EmptySurface,
// BadCoordinate, BadParameter, FlawedSurface (of a region).
double expectedBoxes(const SurfaceView& surface, const Options& options, Execution& execution);

constexpr std::size_t ExpectedDepths = 3; // from 0

struct ExpectedRow
{
  double size = 0; // of boxes, user units
  std::array<double, ExpectedDepths>
    boxes{}; // at each refinement depth along the surface; at least 1
};

// The same for several grids: the first row is of the options' cell size, the others of the longest side by 25, 50, 100
// and 200. Numbers are rounded to what is known of them.
std::array<ExpectedRow, 5> expectedRows(
  const SurfaceView& surface, const Options& options, Execution& execution);

}
