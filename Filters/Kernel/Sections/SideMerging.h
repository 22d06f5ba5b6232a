// SPDX-License-Identifier: BSD-3-Clause
// Unites polygons of a side (SideFaces.h) that solvers would refuse as cells: those in which a cell's neighbour was across the
// side, so that a sliver is left.
#pragma once

#include "Sections/SideFaces.h"

#include <functional>

namespace cartesian
{

struct SideMerging
{
  // As checkMesh has them.
  static constexpr double MostSkewness = 4;
  static constexpr double MostNonOrthogonality = 70; // degrees
};

// Of two polygons whose edge is skew or not orthogonal, the smaller is united with its neighbour along the longest edge, in rounds,
// as long as there are any. `areOne`: whether cells may be united. `isInner`: whether a face is between cells.
void mergeSkew(const std::vector<double>& points,
  const std::function<bool(std::uint32_t, std::uint32_t)>& areOne,
  const std::function<bool(std::size_t)>& isInner, SideFaces& side);

}
