// SPDX-License-Identifier: BSD-3-Clause
#include "Surface/SurfaceEdges.h"

#include "Base/Rings.h"

namespace cartesian
{

SurfaceEdges::SurfaceEdges(const Surface& surface, Execution& execution)
{
  constexpr std::size_t TrianglesAChunk = 1 << 12;
  uses_ = fillBuckets<EdgeUse>(
    surface.triangles.size(), TrianglesAChunk, surface.vertices.size(),
    [&](std::size_t begin, std::size_t end, auto&& add) {
      for (std::size_t t = begin; t < end; ++t)
      {
        const auto& v = surface.triangles[t];
        for (std::size_t i = 0; i < 3 && !namesAVertexTwice(v); ++i)
        {
          const std::uint32_t a = v[i];
          const std::uint32_t b = following(v, i);
          add(
            std::min(a, b), EdgeUse{ std::max(a, b), static_cast<std::uint32_t>(2 * t + (a > b)) });
        }
      }
    },
    execution);
}

}
