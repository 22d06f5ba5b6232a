// SPDX-License-Identifier: BSD-3-Clause
// User options for small cells (section 4.10).
#pragma once

#include "Base/Range.h"

#include <cstdint>
#include <vector>

namespace cartesian
{

enum class SmallCells : std::uint8_t
{
  Remove = 0, // their inner faces become boundary faces of their neighbours
  Merge = 1,  // they become part of a neighbour
};

// A boundary's own R: it applies to cells most of whose patches belong to it.
struct BoundaryRatio
{
  std::int32_t boundary;
  double ratio; // in SmallCellSpec::Ratios
};

struct SmallCellSpec
{
  static constexpr Range Ratios{ 0, 1, false };

  // R, where small cells are removed: those below this part of their box's volume are.
  double ratio = 1e-3;

  SmallCells handling = SmallCells::Merge;
  std::vector<BoundaryRatio> boundaryRatios; // each boundary once
};

// The R of cells of that boundary: its own, if it has one, else this.
double ratioOf(const SmallCellSpec& spec, std::int32_t boundary, double otherwise);

}
