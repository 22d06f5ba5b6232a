// SPDX-License-Identifier: BSD-3-Clause
// The loops that the open edges of a surface form.
#pragma once

#include "Surface/SurfaceEdges.h"

#include <vector>

namespace cartesian
{

// An open edge, as seen from one of its ends.
struct RimEdge
{
  std::uint32_t from;
  std::uint32_t to;
  std::uint32_t triangle;
  int along; // triangles that run this way minus those that run the other way

  bool operator<(const RimEdge& other) const
  {
    return from != other.from ? from < other.from : to < other.to;
  }
};

// Where loops touch at a vertex, how one goes on there.
enum class RimTurns
{
  ToLowest, // to the lowest vertex
  Sharpest, // with the smallest angle between its edges, as a loop around something narrow does
};

// Each loop of edges that an odd number of triangles use, in turn from its lowest vertex on; it visits no vertex twice. In order of
// their first edges.
std::vector<std::vector<RimEdge>> rimLoopsOf(
  const Surface& surface, const SurfaceEdges& edges, RimTurns turns = RimTurns::ToLowest);

// Levels.
double lengthOf(const Surface& surface, const std::vector<RimEdge>& loop);

}
