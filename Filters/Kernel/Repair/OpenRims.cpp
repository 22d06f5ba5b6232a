// SPDX-License-Identifier: BSD-3-Clause
#include "Repair/OpenRims.h"

#include "Surface/SurfaceEdges.h"

#include <algorithm>

namespace cartesian
{

std::vector<OpenEdge> openEdgesOf(const Surface& surface, Execution& execution)
{
  std::vector<OpenEdge> open;
  SurfaceEdges(surface, execution)
    .forEach([&](std::uint32_t lower, const EdgeUse* begin, const EdgeUse* end) {
      if ((end - begin) % 2 == 1)
      {
        open.push_back({ begin->triangle(), lower, begin->upper });
      }
    });
  return open;
}

std::uint32_t goalOf(const CornerMoves& moves, std::uint32_t corner)
{
  const auto found = moves.find(corner);
  return found != moves.end() ? found->second : corner;
}

OpenRims::OpenRims(const Surface& surface, std::vector<OpenEdge> edges)
  : surface_(surface)
  , edges_(std::move(edges))
{
  std::sort(edges_.begin(), edges_.end());
  for (const OpenEdge& edge : edges_)
  {
    ends_.emplace_back(edge.lower, edge.upper);
    ends_.emplace_back(edge.upper, edge.lower);
    for (const std::uint32_t corner : surface.triangles[edge.triangle])
    {
      for (const std::uint32_t other : surface.triangles[edge.triangle])
      {
        besides_.emplace_back(corner, other);
      }
    }
  }
  std::sort(ends_.begin(), ends_.end());
  std::sort(besides_.begin(), besides_.end());
}

std::pair<const OpenEdge*, const OpenEdge*> OpenRims::of(std::uint32_t triangle) const
{
  const auto range = std::equal_range(edges_.begin(), edges_.end(), OpenEdge{ triangle, 0, 0 },
    [](const OpenEdge& a, const OpenEdge& b) { return a.triangle < b.triangle; });
  return { edges_.data() + (range.first - edges_.begin()),
    edges_.data() + (range.second - edges_.begin()) };
}

std::vector<std::uint32_t> OpenRims::corners() const
{
  std::vector<std::uint32_t> all;
  for (const auto& [corner, other] : ends_)
  {
    if (all.empty() || all.back() != corner)
    {
      all.push_back(corner);
    }
  }
  return all;
}

std::vector<std::uint32_t> OpenRims::triangles() const
{
  std::vector<std::uint32_t> all;
  for (const OpenEdge& edge : edges_)
  {
    if (all.empty() || all.back() != edge.triangle)
    {
      all.push_back(edge.triangle);
    }
  }
  return all;
}

bool OpenRims::areOfOneTriangle(std::uint32_t a, std::uint32_t b) const
{
  return std::binary_search(besides_.begin(), besides_.end(), std::pair{ a, b });
}

std::vector<std::uint32_t> OpenRims::near(std::uint32_t corner, double length) const
{
  std::map<std::uint32_t, double> reached{ { corner, 0 } };
  std::vector<std::uint32_t> next{ corner };
  while (!next.empty())
  {
    const std::uint32_t from = next.back();
    next.pop_back();
    for (auto end = std::lower_bound(ends_.begin(), ends_.end(), std::pair{ from, 0U });
         end != ends_.end() && end->first == from; ++end)
    {
      const double way =
        reached[from] + norm(minus(surface_.vertices[end->second], surface_.vertices[from]));
      const auto [known, isNew] = reached.emplace(end->second, way);
      if (way <= length && (isNew || way < known->second))
      {
        known->second = way;
        next.push_back(end->second);
      }
      else if (isNew)
      {
        reached.erase(known);
      }
    }
  }
  std::vector<std::uint32_t> all;
  all.reserve(reached.size());
  for (const auto& [vertex, way] : reached)
  {
    all.push_back(vertex);
  }
  return all;
}

}
