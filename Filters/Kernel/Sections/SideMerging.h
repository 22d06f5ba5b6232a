// SPDX-License-Identifier: BSD-3-Clause
// Unites slivers of a side (SideFaces.h) with polygons beside them: faces of cells that reach further behind the side.
#pragma once

#include "Sections/SideFaces.h"

#include <functional>
#include <limits>

namespace cartesian
{

struct SideMerging
{
  // As checkMesh has them.
  static constexpr double MostSkewness = 4;
  static constexpr double MostNonOrthogonality = 70; // degrees

  // The sine of the angle between two edges that are one; and of others, if one is so much shorter, and the point between them stands
  // aside by no more than a part of the longer one.
  static constexpr double Straight = 1e-6;
  static constexpr double Bent = 0.35;
  static constexpr double Short = 0.25;
  static constexpr double Aside = 0.03;
};

// In a function of the boundary of a face: it is between cells.
constexpr long long InnerEdge = std::numeric_limits<long long>::min();

// Points in the middle of an edge between the same two sides are left out if it is straight there, or nearly so beside a short
// part: so of a round wall what is between a short chord and a longer one is lost. Of two polygons whose edge is skew or not orthogonal, the
// smaller is united with the neighbour that leaves the fewest such edges, of equal ones that along the longest edge, if they become fewer;
// and so is one with a skew edge on a boundary, or one whose centre is beyond an edge; in rounds, as long as there are any.
// `areOne`: whether cells may be united. `boundaryOf`: of a face (BorderEdge::beside).
void mergeSkew(const std::vector<double>& points,
  const std::function<bool(std::uint32_t, std::uint32_t)>& areOne,
  const std::function<long long(std::size_t)>& boundaryOf, SideFaces& side);

}
