// SPDX-License-Identifier: BSD-3-Clause
// The lines that decide how sheets are oriented: through the largest triangles of each sheet.
#pragma once

#include "Repair/ManifoldComponents.h"

#include <tuple>

namespace cartesian
{

// A line along one axis through a triangle. Lines are ordered by importance: when there are too
// many, the last ones are dropped.
struct SampleRay
{
  Point place;                           // on even levels, 0 along the line
  std::size_t rank;                      // of the triangle in its sheet: 0 for the largest
  Wide area;                             // twice the triangle's area, projected along the line
  std::uint32_t sheet;                   // that the triangle is of
  std::array<std::uint32_t, 3> triangle; // its vertices, sorted

  bool operator<(const SampleRay& other) const
  {
    return rank != other.rank
      ? rank < other.rank
      : std::tie(other.area, triangle, place) < std::tie(area, other.triangle, other.place);
  }
};

// The lines along x, y and z.
std::array<std::vector<SampleRay>, 3> findSampleRays(
  const Surface& surface, const ManifoldComponents& sheets, Execution& execution);

}
