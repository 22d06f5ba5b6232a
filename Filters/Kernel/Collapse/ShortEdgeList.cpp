// SPDX-License-Identifier: BSD-3-Clause
#include "Collapse/ShortEdgeList.h"

#include "Base/Sorting.h"
#include "Lattice/Vector.h"

#include <algorithm>

namespace cartesian
{

namespace
{

constexpr std::size_t BoxesAChunk = 256;

class ShortEdgeLister
{
public:
  ShortEdgeLister(
    const PolyhedralFaces& faces, double ratio, const std::function<bool(std::size_t)>& stays)
    : faces_(faces)
    , ratio_(ratio)
    , stays_(stays)
  {
  }

  std::vector<ShortEdge> run(Execution& execution) const
  {
    const std::size_t count = faces_.sides.polyhedral.size();
    std::vector<std::vector<ShortEdge>> parts(chunks(count, BoxesAChunk));
    execution.forEach(count, BoxesAChunk, [&](std::size_t begin, std::size_t end) {
      std::vector<ShortEdge>& edges = parts[begin / BoxesAChunk];
      for (std::size_t n = begin; n < end; ++n)
      {
        execution.poll();
        listEdgesOf(n, edges);
      }
      std::sort(edges.begin(), edges.end());
      leaveOutRepeated(edges);
    });
    std::vector<ShortEdge> all = concatenated(parts);
    sortAll(all, execution);
    leaveOutRepeated(all);
    return all;
  }

private:
  double shortestEdge(std::uint32_t box) const
  {
    if (box == None)
    {
      return 1e300;
    }
    const Box whole = faces_.boxes.box(box);
    const Vector size = minus(whole.high, whole.low);
    return std::min({ size[0], size[1], size[2] });
  }

  void addShortEdges(const RawVector<std::size_t>& start, const RawVector<std::uint32_t>& corners,
    std::size_t face, double unit, std::vector<ShortEdge>& edges) const
  {
    const double most = ratio_ * unit;
    std::uint32_t from = corners[start[face + 1] - 1];
    for (std::size_t i = start[face]; i < start[face + 1]; ++i)
    {
      const std::uint32_t to = corners[i];
      if (std::min(from, to) < faces_.nodes.patchPoints && isShort(from, to, most))
      {
        edges.push_back({ std::min(from, to), std::max(from, to), static_cast<float>(unit) });
      }
      from = to;
    }
  }

  // Tests integers first, as most edges are long.
  bool isShort(std::uint32_t from, std::uint32_t to, double most) const
  {
    const Point& p = faces_.nodes.at[from];
    const Point& q = faces_.nodes.at[to];
    const auto reach = static_cast<std::uint32_t>(most) + 1;
    for (std::size_t axis = 0; axis < 3; ++axis)
    {
      if (std::max(p[axis], q[axis]) - std::min(p[axis], q[axis]) > reach)
      {
        return false;
      }
    }
    const Vector way = minus(q, p);
    return dot(way, way) < most * most;
  }

  void listEdgesOf(std::size_t n, std::vector<ShortEdge>& edges) const
  {
    if (stays_(n))
    {
      return;
    }
    const std::uint32_t box = faces_.sides.polyhedral[n];
    const double shortest = shortestEdge(box);
    if (const std::uint32_t cut = faces_.sides.patchBox[n]; cut != None)
    {
      for (std::size_t p = faces_.patches.boxStart[cut]; p < faces_.patches.boxStart[cut + 1]; ++p)
      {
        addShortEdges(faces_.patches.start, faces_.patches.corners, p, shortest, edges);
      }
    }
    for (std::size_t s = faces_.sides.ownStart[n]; s < faces_.sides.ownStart[n + 1]; ++s)
    {
      const Side& side = faces_.sides.common[s];
      const double unit = std::min(shortest, shortestEdge(side.low == box ? side.high : side.low));
      for (std::size_t f = faces_.inner.sideStart[s]; f < faces_.inner.sideStart[s + 1]; ++f)
      {
        addShortEdges(faces_.inner.start, faces_.inner.nodes, f, unit, edges);
      }
    }
  }

  // Keeps the one with the smallest unit.
  static void leaveOutRepeated(std::vector<ShortEdge>& sorted)
  {
    sorted.erase(std::unique(sorted.begin(), sorted.end(),
                   [](const ShortEdge& x, const ShortEdge& y) { return x.a == y.a && x.b == y.b; }),
      sorted.end());
  }

  const PolyhedralFaces& faces_;
  double ratio_;
  const std::function<bool(std::size_t)>& stays_;
};

}

std::vector<ShortEdge> listShortEdges(const PolyhedralFaces& faces, double ratio,
  const std::function<bool(std::size_t)>& stays, Execution& execution)
{
  return ShortEdgeLister(faces, ratio, stays).run(execution);
}

}
