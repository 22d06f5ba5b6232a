// SPDX-License-Identifier: BSD-3-Clause
// Moves the outline of one division of a plane onto that of another, where they differ by chords of the same curve; polygons near
// the outline move along, so that none turns over.
#pragma once

#include "Sections/PlanePolygons.h"

#include <map>

namespace cartesian
{

struct OutlineFitting
{
  // Outlines are one where they are nearer than this part of the longer edge at a point.
  static constexpr double Nearby = 0.1;

  // Points up to so many of the longest ways from the outline move along, less with distance.
  static constexpr double Fade = 6;
};

struct FittedOutline
{
  PlanePolygons polygons; // as they were, and new points at the end: those of the other outline

  // The new points on edges of before, in order from the lower end to the higher.
  std::map<std::array<std::uint32_t, 2>, std::vector<std::uint32_t>> inserted;
};

// `second`: what moves. What is not near stays.
FittedOutline fitOutline(const PlanePolygons& first, const PlanePolygons& second);

}
