// SPDX-License-Identifier: BSD-3-Clause
// New vertices on the edges of triangles.
#pragma once

#include <algorithm>
#include <array>
#include <cstdint>
#include <map>
#include <vector>

namespace cartesian
{

// By the ends of an edge, the lower first; then by how far along from there, as a part of the edge or in levels.
using EdgePoints = std::map<std::array<std::uint32_t, 2>, std::map<double, std::uint32_t>>;

// The new vertices on an edge, in the requested direction.
inline std::vector<std::uint32_t> pointsOn(
  const EdgePoints& onEdge, std::uint32_t from, std::uint32_t to)
{
  std::vector<std::uint32_t> points;
  const auto found = onEdge.find({ std::min(from, to), std::max(from, to) });
  if (found != onEdge.end())
  {
    for (const auto& [along, vertex] : found->second)
    {
      points.push_back(vertex);
    }
  }
  if (to < from)
  {
    std::reverse(points.begin(), points.end());
  }
  return points;
}

}
