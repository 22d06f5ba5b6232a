#include "SurfaceCheck.h"

#include <algorithm>

namespace cartesian
{

namespace
{

constexpr std::size_t VerticesAChunk = 1 << 13;

void judge(std::uint32_t lower, const EdgeUse* begin, const EdgeUse* end, SurfaceCheck& result)
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
  const std::size_t count = edges.vertices();
  std::vector<SurfaceCheck> parts(chunks(count, VerticesAChunk));
  execution.forEach(count, VerticesAChunk, [&](std::size_t first, std::size_t last) {
    SurfaceCheck& part = parts[first / VerticesAChunk];
    edges.forEach(first, last, [&](std::uint32_t lower, const EdgeUse* begin, const EdgeUse* end) {
      judge(lower, begin, end, part);
    });
  });
  SurfaceCheck result;
  for (const SurfaceCheck& part : parts)
  {
    add(part, result);
  }
  return result;
}

}
