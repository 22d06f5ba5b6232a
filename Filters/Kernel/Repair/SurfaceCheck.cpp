// SPDX-License-Identifier: BSD-3-Clause
#include "Repair/SurfaceCheck.h"

#include <algorithm>

namespace cartesian
{

namespace
{

void checkEdge(std::uint32_t lower, const EdgeUse* begin, const EdgeUse* end, SurfaceCheck& result)
{
  const auto uses = static_cast<std::size_t>(end - begin);
  const auto down = static_cast<std::size_t>(
    std::count_if(begin, end, [](const EdgeUse& use) { return use.down(); }));
  const bool open = uses % 2 == 1;
  const bool inconsistent = !open && 2 * down != uses;
  const bool nonManifold = uses > 2;
  result.openEdges += open;
  result.inconsistentEdges += inconsistent;
  result.nonManifoldEdges += nonManifold;
  if ((open || inconsistent || nonManifold) && result.places.size() < SurfaceCheck::MostPlaces)
  {
    result.places.push_back(
      { open ? "open" : (inconsistent ? "inconsistently oriented" : "non-manifold"),
        { lower, begin->upper }, begin->triangle() });
  }
}

void add(const SurfaceCheck& part, SurfaceCheck& sum)
{
  sum.openEdges += part.openEdges;
  sum.inconsistentEdges += part.inconsistentEdges;
  sum.nonManifoldEdges += part.nonManifoldEdges;
  for (const auto& place : part.places)
  {
    if (sum.places.size() < SurfaceCheck::MostPlaces)
    {
      sum.places.push_back(place);
    }
  }
}

}

SurfaceCheck check(const SurfaceEdges& edges, Execution& execution)
{
  std::vector<SurfaceCheck> parts(edges.chunkCount());
  edges.forEach(execution,
    [&](std::size_t chunk, std::uint32_t lower, const EdgeUse* begin, const EdgeUse* end) {
      checkEdge(lower, begin, end, parts[chunk]);
    });
  SurfaceCheck result;
  for (const SurfaceCheck& part : parts)
  {
    add(part, result);
  }
  return result;
}

}
