// SPDX-License-Identifier: BSD-3-Clause
#include "Repair/RimLoops.h"

#include "Base/Sorting.h"
#include "Lattice/Vector.h"

#include <algorithm>

namespace cartesian
{

namespace
{

// Edges that an odd number of triangles use, listed from both ends.
std::vector<RimEdge> findRims(const SurfaceEdges& edges)
{
  std::vector<RimEdge> rims;
  edges.forEach([&](std::uint32_t lower, const EdgeUse* begin, const EdgeUse* end) {
    if ((end - begin) % 2 == 1)
    {
      const auto down = std::count_if(begin, end, [](const EdgeUse& use) { return use.down(); });
      const auto up = static_cast<int>((end - begin) - 2 * down);
      rims.push_back({ lower, begin->upper, begin->triangle(), up });
      rims.push_back({ begin->upper, lower, begin->triangle(), -up });
    }
  });
  std::sort(rims.begin(), rims.end());
  return rims;
}

// Separates rims into loops that visit no vertex twice.
class RimTracer
{
public:
  RimTracer(const Surface& surface, const std::vector<RimEdge>& rims, RimTurns turns)
    : surface_(surface)
    , rims_(rims)
    , turns_(turns)
    , used_(rims.size())
    , next_(surface.vertices.size() + 1)
    , place_(surface.vertices.size(), NotOnWalk)
  {
    for (const RimEdge& rim : rims)
    {
      ++next_[rim.from];
    }
    scan(next_);
    end_.assign(next_.begin() + 1, next_.end());
  }

  // Calls visit(begin, end) with the edges of each loop, in order.
  template <class Visitor>
  void forEachLoop(Visitor&& visit)
  {
    for (const RimEdge& first : rims_)
    {
      std::uint32_t at = first.from;
      place_[at] = 0;
      while (const RimEdge* edge = take(at))
      {
        walk_.push_back(*edge);
        at = edge->to;
        if (place_[at] != NotOnWalk)
        {
          visit(walk_.data() + place_[at], walk_.data() + walk_.size());
          cutBack(place_[at]);
        }
        place_[at] = walk_.size();
      }
      place_[first.from] = NotOnWalk; // every vertex has an even number of edges: the walk is over
    }
  }

private:
  static constexpr std::size_t NotOnWalk = ~std::size_t(0);

  // An unused edge from a vertex, or null.
  const RimEdge* take(std::uint32_t vertex)
  {
    std::size_t& next = next_[vertex];
    while (next != end_[vertex] && used_[next])
    {
      ++next;
    }
    if (next == end_[vertex])
    {
      return nullptr;
    }
    const std::size_t taken = turns_ == RimTurns::Sharpest ? sharpest(vertex) : next;
    const RimEdge& edge = rims_[taken];
    used_[taken] = true;
    const auto back =
      std::lower_bound(rims_.begin(), rims_.end(), RimEdge{ edge.to, vertex, 0, 0 });
    used_[static_cast<std::size_t>(back - rims_.begin())] = true;
    return &edge;
  }

  // Of the unused edges from a vertex, of which there is one, that with the smallest angle to the last one of the walk.
  std::size_t sharpest(std::uint32_t vertex) const
  {
    std::size_t best = next_[vertex];
    double most = -HUGE_VAL;
    for (std::size_t r = next_[vertex]; r < end_[vertex] && !walk_.empty(); ++r)
    {
      const double cosine = dot(wayTo(rims_[r].to, vertex), wayTo(walk_.back().from, vertex));
      if (!used_[r] && cosine > most)
      {
        best = r;
        most = cosine;
      }
    }
    return best;
  }

  Vector wayTo(std::uint32_t to, std::uint32_t from) const
  {
    return unit(minus(surface_.vertices[to], surface_.vertices[from]));
  }

  void cutBack(std::size_t size)
  {
    for (; walk_.size() > size; walk_.pop_back())
    {
      place_[walk_.back().to] = NotOnWalk;
    }
  }

  const Surface& surface_;
  const std::vector<RimEdge>& rims_;
  const RimTurns turns_;
  std::vector<bool> used_;
  std::vector<std::size_t> next_; // edge from each vertex
  std::vector<std::size_t> end_;
  std::vector<std::size_t> place_; // of a vertex on the walk
  std::vector<RimEdge> walk_;
};

}

std::vector<std::vector<RimEdge>> rimLoopsOf(
  const Surface& surface, const SurfaceEdges& edges, RimTurns turns)
{
  std::vector<std::vector<RimEdge>> loops;
  const std::vector<RimEdge> rims = findRims(edges);
  if (rims.empty())
  {
    return loops;
  }
  RimTracer(surface, rims, turns).forEachLoop([&](const RimEdge* begin, const RimEdge* end) {
    std::vector<RimEdge>& loop = loops.emplace_back(begin, end);
    std::rotate(loop.begin(),
      std::min_element(loop.begin(), loop.end(),
        [](const RimEdge& a, const RimEdge& b) { return a.from < b.from; }),
      loop.end());
  });
  std::sort(
    loops.begin(), loops.end(), [](const auto& a, const auto& b) { return a.front() < b.front(); });
  return loops;
}

double lengthOf(const Surface& surface, const std::vector<RimEdge>& loop)
{
  double length = 0;
  for (const RimEdge& edge : loop)
  {
    length += norm(minus(surface.vertices[edge.to], surface.vertices[edge.from]));
  }
  return length;
}

}
