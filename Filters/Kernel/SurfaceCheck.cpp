#include "SurfaceCheck.h"

#include <algorithm>

namespace cartesian
{

namespace
{

constexpr std::size_t VerticesAChunk = 1 << 13;

// A triangle's use of an edge, filed under the edge's lower vertex.
struct Use
{
  std::uint32_t upper;
  std::uint32_t triangleTwice; // twice the triangle, plus one where it runs downward

  bool operator<(const Use& other) const
  {
    return upper != other.upper ? upper < other.upper : triangleTwice < other.triangleTwice;
  }
};

// The uses of all edges by lower vertex: counted, scanned, filled.
struct EdgeTable
{
  std::vector<std::size_t> start;
  std::vector<Use> uses;

  explicit EdgeTable(const Surface& surface)
    : start(surface.vertices.size() + 1)
  {
    forEachEdge(surface, [&](std::uint32_t lower, const Use&) { ++start[lower + 1]; });
    for (std::size_t v = 0; v + 1 < start.size(); ++v)
    {
      start[v + 1] += start[v];
    }
    uses.resize(start.back());
    std::vector<std::size_t> next(start.begin(), start.end() - 1);
    forEachEdge(surface, [&](std::uint32_t lower, const Use& use) { uses[next[lower]++] = use; });
  }

  template <class Visitor>
  static void forEachEdge(const Surface& surface, Visitor&& visit)
  {
    for (std::size_t t = 0; t < surface.triangles.size(); ++t)
    {
      const auto& v = surface.triangles[t];
      if (v[0] == v[1] || v[1] == v[2] || v[2] == v[0])
      {
        continue; // runs to and fro along one edge: its neighbours meet there
      }
      for (int i = 0; i < 3; ++i)
      {
        const std::uint32_t a = v[i];
        const std::uint32_t b = v[(i + 1) % 3];
        visit(std::min(a, b), Use{ std::max(a, b), static_cast<std::uint32_t>(2 * t + (a > b)) });
      }
    }
  }
};

void judge(std::uint32_t lower, const Use* begin, const Use* end, SurfaceCheck& result)
{
  const std::size_t uses = end - begin;
  const std::size_t down =
    std::count_if(begin, end, [](const Use& u) { return u.triangleTwice & 1; });
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
  EdgeTable table(surface);
  const std::size_t count = surface.vertices.size();
  std::vector<SurfaceCheck> parts(chunks(count, VerticesAChunk));
  execution.forEach(count, VerticesAChunk, [&](std::size_t begin, std::size_t end) {
    SurfaceCheck& part = parts[begin / VerticesAChunk];
    for (std::size_t v = begin; v < end; ++v)
    {
      Use* first = table.uses.data() + table.start[v];
      Use* const last = table.uses.data() + table.start[v + 1];
      std::sort(first, last);
      while (first != last)
      {
        const Use* const group = first;
        while (first != last && first->upper == group->upper)
        {
          ++first;
        }
        judge(static_cast<std::uint32_t>(v), group, first, part);
      }
    }
  });
  SurfaceCheck result;
  for (const SurfaceCheck& part : parts)
  {
    add(part, result);
  }
  return result;
}

}
