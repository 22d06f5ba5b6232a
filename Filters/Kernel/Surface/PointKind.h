// SPDX-License-Identifier: BSD-3-Clause
// What of the surface a point is on, from its sharp edges and borders (Features.h) to the nodes of the mesh (Nodes.h).
#pragma once

#include <algorithm>
#include <cstdint>

namespace cartesian
{

// In order: points that become one are of the higher kind.
enum class PointKind : std::uint8_t
{
  OffSurface = 0, // a node of the grid only
  OnSurface = 1,  // or a point of rebuilt boxes (BoxRebuilding.h)
  OnEdge = 2,     // on a sharp or open edge, or a border between boundaries
  Corner =
    3, // where such edges end, where more than two meet, or where two turn by more than the feature angle
};

inline void raise(PointKind& kind, PointKind other)
{
  kind = std::max(kind, other);
}

}
