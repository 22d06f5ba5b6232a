// Which triangles of the surface meet at which edge.
#pragma once

#include "Surface.h"

#include <algorithm>

namespace cartesian
{

// A triangle's use of an edge, filed under the edge's lower vertex.
struct EdgeUse
{
  std::uint32_t upper;
  std::uint32_t triangleTwice; // twice the triangle, plus one where it runs downward

  std::uint32_t triangle() const { return triangleTwice / 2; }
  bool operator<(const EdgeUse& other) const
  {
    return upper != other.upper ? upper < other.upper : triangleTwice < other.triangleTwice;
  }
};

// The uses of all edges by lower vertex: counted, scanned, filled. Triangles without three different
// vertices use none: they run to and fro along one edge, where their neighbours meet.
class SurfaceEdges
{
public:
  explicit SurfaceEdges(const Surface& surface);

  // Calls visit(chunk, lower, first, last) for the uses of each edge, on all threads, those of a
  // chunk of vertices in order.
  template <class Visitor>
  void forEach(Execution& execution, Visitor&& visit)
  {
    const std::size_t count = start_.size() - 1;
    execution.forEach(count, VerticesAChunk, [&](std::size_t begin, std::size_t end) {
      for (std::size_t v = begin; v < end; ++v)
      {
        EdgeUse* first = uses_.data() + start_[v];
        EdgeUse* const last = uses_.data() + start_[v + 1];
        std::sort(first, last);
        while (first != last)
        {
          const EdgeUse* const group = first;
          while (first != last && first->upper == group->upper)
          {
            ++first;
          }
          visit(begin / VerticesAChunk, static_cast<std::uint32_t>(v), group,
            static_cast<const EdgeUse*>(first));
        }
      }
    });
  }

  std::size_t chunkCount() const { return chunks(start_.size() - 1, VerticesAChunk); }

private:
  static constexpr std::size_t VerticesAChunk = 1 << 13;

  std::vector<std::size_t> start_;
  std::vector<EdgeUse> uses_;
};

}
