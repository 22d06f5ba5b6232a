// SPDX-License-Identifier: BSD-3-Clause
// The edges of a surface, each with the triangles that use it.
#pragma once

#include "Base/Sorting.h"
#include "Surface/Surface.h"

namespace cartesian
{

// A triangle's use of an edge, listed at the edge's lower vertex.
struct EdgeUse
{
  std::uint32_t upper;         // the edge's other vertex
  std::uint32_t triangleTwice; // twice the triangle, plus one where it runs from upper to lower

  std::uint32_t triangle() const { return triangleTwice / 2; }
  bool down() const { return triangleTwice % 2 == 1; }

  bool operator<(const EdgeUse& other) const
  {
    return upper != other.upper ? upper < other.upper : triangleTwice < other.triangleTwice;
  }
};

// Triangles that contain a vertex twice run back and forth along one edge and are left out: their
// neighbours on both sides meet at that edge.
class SurfaceEdges
{
public:
  SurfaceEdges(const Surface& surface, Execution& execution);

  // Calls visit(lower, begin, end) with the uses of each edge, in order of vertices.
  template <class Visitor>
  void forEach(Visitor&& visit) const
  {
    forEachFrom(0, vertices(), visit);
  }

  // Calls visit(chunk, lower, begin, end) likewise, on all threads; in order within each chunk of
  // vertices.
  template <class Visitor>
  void forEach(Execution& execution, Visitor&& visit) const
  {
    execution.forEach(vertices(), VerticesAChunk, [&](std::size_t first, std::size_t last) {
      forEachFrom(first, last, [&](std::uint32_t lower, const EdgeUse* begin, const EdgeUse* end) {
        visit(first / VerticesAChunk, lower, begin, end);
      });
    });
  }

  std::size_t chunkCount() const { return chunks(vertices(), VerticesAChunk); }

private:
  static constexpr std::size_t VerticesAChunk = 1 << 11;

  template <class Visitor>
  void forEachFrom(std::size_t first, std::size_t last, Visitor&& visit) const
  {
    for (std::size_t v = first; v < last; ++v)
    {
      const EdgeUse* use = uses_.begin(v);
      const EdgeUse* const end = uses_.end(v);
      while (use != end)
      {
        const EdgeUse* const begin = use;
        while (use != end && use->upper == begin->upper)
        {
          ++use;
        }
        visit(static_cast<std::uint32_t>(v), begin, use);
      }
    }
  }

  std::size_t vertices() const { return uses_.start.size() - 1; }

  Buckets<EdgeUse> uses_; // of each lower vertex
};

// Which edge of its triangle a use is: 0 from the first corner to the second, and so on. `lower`: the edge's lower vertex.
inline unsigned edgeOf(const Surface& surface, const EdgeUse& use, std::uint32_t lower)
{
  const auto& v = surface.triangles[use.triangle()];
  const std::uint32_t from = use.down() ? use.upper : lower;
  return v[0] == from ? 0 : (v[1] == from ? 1 : 2);
}

inline bool namesAVertexTwice(const std::array<std::uint32_t, 3>& triangle)
{
  return triangle[0] == triangle[1] || triangle[1] == triangle[2] || triangle[2] == triangle[0];
}

}
