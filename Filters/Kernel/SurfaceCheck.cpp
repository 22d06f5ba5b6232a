#include "SurfaceCheck.h"

#include "SurfaceEdges.h"

namespace cartesian
{

namespace
{

void judge(std::uint32_t lower, const EdgeUse* begin, const EdgeUse* end, SurfaceCheck& result)
{
  const std::size_t uses = end - begin;
  const std::size_t down =
    std::count_if(begin, end, [](const EdgeUse& u) { return u.triangleTwice & 1; });
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
        { lower, begin->upper }, begin->triangleTwice / 2 });
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

SurfaceCheck check(const Surface& surface, Execution& execution)
{
  SurfaceEdges edges(surface);
  std::vector<SurfaceCheck> parts(edges.chunkCount());
  edges.forEach(execution,
    [&](std::size_t chunk, std::uint32_t lower, const EdgeUse* first, const EdgeUse* last) {
      judge(lower, first, last, parts[chunk]);
    });
  SurfaceCheck result;
  for (const SurfaceCheck& part : parts)
  {
    add(part, result);
  }
  return result;
}

}
