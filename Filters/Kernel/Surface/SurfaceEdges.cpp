// SPDX-License-Identifier: BSD-3-Clause
#include "Surface/SurfaceEdges.h"

#include "Base/Sorting.h"

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
    for (std::size_t i = 0; i < 3 && !namesAVertexTwice(v); ++i)
    {
      const std::uint32_t a = v[i];
      const std::uint32_t b = v[(i + 1) % 3];
      visit(std::min(a, b), EdgeUse{ std::max(a, b), static_cast<std::uint32_t>(2 * t + (a > b)) });
    }
  }
}

}

SurfaceEdges::SurfaceEdges(const Surface& surface, Execution& execution)
  : start_(surface.vertices.size() + 1)
{
  forEachUse(surface, [&](std::uint32_t lower, const EdgeUse&) { ++start_[lower]; });
  uses_.resize(scan(start_));
  std::vector<std::size_t> next(start_.begin(), start_.end() - 1);
  forEachUse(surface, [&](std::uint32_t lower, const EdgeUse& use) { uses_[next[lower]++] = use; });
  execution.forEach(vertices(), VerticesAChunk, [&](std::size_t begin, std::size_t end) {
    for (std::size_t v = begin; v < end; ++v)
    {
      std::sort(uses_.data() + start_[v], uses_.data() + start_[v + 1]);
    }
  });
}

}
