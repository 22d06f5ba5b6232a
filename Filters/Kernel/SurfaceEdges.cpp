#include "SurfaceEdges.h"

namespace cartesian
{

namespace
{

template <class Visitor>
void forEachUse(const Surface& surface, Visitor&& visit)
{
  for (std::size_t t = 0; t < surface.triangles.size(); ++t)
  {
    const auto& v = surface.triangles[t];
    if (v[0] == v[1] || v[1] == v[2] || v[2] == v[0])
    {
      continue;
    }
    for (int i = 0; i < 3; ++i)
    {
      const std::uint32_t a = v[i];
      const std::uint32_t b = v[(i + 1) % 3];
      visit(std::min(a, b), EdgeUse{ std::max(a, b), static_cast<std::uint32_t>(2 * t + (a > b)) });
    }
  }
}

}

SurfaceEdges::SurfaceEdges(const Surface& surface)
  : start_(surface.vertices.size() + 1)
{
  forEachUse(surface, [&](std::uint32_t lower, const EdgeUse&) { ++start_[lower + 1]; });
  for (std::size_t v = 0; v + 1 < start_.size(); ++v)
  {
    start_[v + 1] += start_[v];
  }
  uses_.resize(start_.back());
  std::vector<std::size_t> next(start_.begin(), start_.end() - 1);
  forEachUse(surface, [&](std::uint32_t lower, const EdgeUse& use) { uses_[next[lower]++] = use; });
}

}
