// SPDX-License-Identifier: BSD-3-Clause
// The faces of a plane graph whose edges are those of two divisions (PlaneOverlay.h).
#pragma once

#include "Sections/PlaneOverlay.h"

namespace cartesian
{

// A polygon of a division is to the left of this way.
struct SidedEdge
{
  std::uint32_t from; // vertices
  std::uint32_t to;
  std::uint32_t polygon; // or NoPolygon: nothing of this division
};

// Fills the polygons and corners of an overlay, and what does not match. `sides`: of both divisions, each edge in either
// direction.
void traceFaces(const std::array<std::vector<SidedEdge>, 2>& sides, PlaneOverlay& overlay);

}
