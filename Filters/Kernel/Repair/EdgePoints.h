// SPDX-License-Identifier: BSD-3-Clause
// New vertices on the edges of triangles, which are divided there.
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

// Appends the parts of a triangle whose i-th edge has the vertices onEdges[i], in turn: fans from the corner opposite to the
// first edge that has any.
inline void divideAtEdges(const std::array<std::uint32_t, 3>& c,
  const std::array<std::vector<std::uint32_t>, 3>& onEdges,
  std::vector<std::array<std::uint32_t, 3>>& parts)
{
  std::size_t i = 0;
  while (i < 3 && onEdges[i].empty())
  {
    ++i;
  }
  if (i == 3)
  {
    parts.push_back(c);
    return;
  }
  const std::size_t j = (i + 1) % 3;
  const std::size_t k = (i + 2) % 3;
  const std::vector<std::uint32_t> None;
  std::vector<std::uint32_t> chain{ c[i] };
  chain.insert(chain.end(), onEdges[i].begin(), onEdges[i].end());
  chain.push_back(c[j]);
  for (std::size_t n = 0; n + 1 < chain.size(); ++n)
  {
    const bool isLast = n + 2 == chain.size();
    divideAtEdges({ chain[n], chain[n + 1], c[k] },
      { None, isLast ? onEdges[j] : None, n == 0 ? onEdges[k] : None }, parts);
  }
}

}
