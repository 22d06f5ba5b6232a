// SPDX-License-Identifier: BSD-3-Clause
#include "Repair/Holes.h"

#include "Base/Sorting.h"
#include "Lattice/Vector.h"
#include "Surface/Places.h"

#include <cmath>
#include <map>
#include <numeric>
#include <queue>
#include <set>

namespace cartesian
{

namespace
{

// The time to fill a rim grows with the cube of its length.
constexpr std::size_t MostRimEdges = 128;

// A lid of a sheet has more than this part of the area of the triangles along its rim.
constexpr double LeastLid = 0.7;

// An open edge, as seen from one of its ends.
struct RimEdge
{
  std::uint32_t from;
  std::uint32_t to;
  std::uint32_t triangle;
  int along; // triangles that run this way minus those that run the other way

  bool operator<(const RimEdge& other) const
  {
    return from != other.from ? from < other.from : to < other.to;
  }
};

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
  RimTracer(const std::vector<RimEdge>& rims, std::size_t vertices)
    : rims_(rims)
    , used_(rims.size())
    , next_(vertices + 1)
    , place_(vertices, NotOnWalk)
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
    const RimEdge& edge = rims_[next];
    used_[next] = true;
    const auto back =
      std::lower_bound(rims_.begin(), rims_.end(), RimEdge{ edge.to, vertex, 0, 0 });
    used_[static_cast<std::size_t>(back - rims_.begin())] = true;
    return &edge;
  }

  void cutBack(std::size_t size)
  {
    for (; walk_.size() > size; walk_.pop_back())
    {
      place_[walk_.back().to] = NotOnWalk;
    }
  }

  const std::vector<RimEdge>& rims_;
  std::vector<bool> used_;
  std::vector<std::size_t> next_; // edge from each vertex
  std::vector<std::size_t> end_;
  std::vector<std::size_t> place_; // of a vertex on the walk
  std::vector<RimEdge> walk_;
};

using Triangle = std::array<std::uint32_t, 3>;

// Triangulates a rim.
class HoleFiller
{
public:
  explicit HoleFiller(const Surface& surface)
    : surface_(surface)
  {
  }

  // Appends the triangles; returns their area. Uses up the rim.
  double fill(std::vector<std::uint32_t>& rim, std::vector<Triangle>& triangles)
  {
    const double area = shorten(rim, triangles);
    return area + fillWithLeast(rim, triangles);
  }

private:
  // A possible triangle that cuts one vertex off the rim.
  struct CutOff
  {
    double length;    // of the new edge
    std::size_t from; // places on the rim
    std::size_t middle;
    std::size_t to;

    bool operator<(const CutOff& other) const // the shortest comes first
    {
      return length != other.length ? length > other.length : middle > other.middle;
    }
  };

  double shorten(std::vector<std::uint32_t>& rim, std::vector<Triangle>& triangles)
  {
    std::size_t left = rim.size();
    if (left <= MostRimEdges)
    {
      return 0;
    }
    std::vector<std::size_t> next(left);
    std::vector<std::size_t> before(left);
    std::priority_queue<CutOff> cutOffs;
    const auto add = [&](std::size_t i) {
      cutOffs.push(
        { norm(minus(surface_.vertices[rim[next[i]]], surface_.vertices[rim[before[i]]])),
          before[i], i, next[i] });
    };
    for (std::size_t i = 0; i < left; ++i)
    {
      next[i] = i + 1 < left ? i + 1 : 0;
      before[i] = i > 0 ? i - 1 : left - 1;
    }
    for (std::size_t i = 0; i < left; ++i)
    {
      add(i);
    }
    double area = 0;
    std::size_t kept = 0;
    while (left > MostRimEdges)
    {
      const CutOff cut = cutOffs.top();
      cutOffs.pop();
      if (next[cut.from] != cut.middle || next[cut.middle] != cut.to)
      {
        continue; // one of the vertices is no longer on the rim
      }
      triangles.push_back({ rim[cut.from], rim[cut.middle], rim[cut.to] });
      area += areaOf(triangles.back());
      next[cut.from] = cut.to;
      before[cut.to] = cut.from;
      next[cut.middle] = cut.middle;
      kept = cut.from;
      --left;
      add(cut.from);
      add(cut.to);
    }
    std::vector<std::uint32_t> rest;
    for (std::size_t i = kept; rest.size() < left; i = next[i])
    {
      rest.push_back(rim[i]);
    }
    rim.swap(rest);
    return area;
  }

  // Dynamic programming, from shorter to longer pieces of the rim: the best triangle on each
  // piece's chord.
  double fillWithLeast(const std::vector<std::uint32_t>& rim, std::vector<Triangle>& triangles)
  {
    const std::size_t n = rim.size();
    least_.assign(n * n, 0);
    best_.assign(n * n, 0);
    for (std::size_t span = 2; span < n; ++span)
    {
      for (std::size_t i = 0; i + span < n; ++i)
      {
        const std::size_t k = i + span;
        double least = HUGE_VAL;
        for (std::size_t j = i + 1; j < k; ++j)
        {
          const double area =
            least_[i * n + j] + least_[j * n + k] + areaOf({ rim[i], rim[j], rim[k] });
          if (area < least)
          {
            least = area;
            best_[i * n + k] = j;
          }
        }
        least_[i * n + k] = least;
      }
    }
    pieces_.assign(1, { 0, n - 1 });
    while (!pieces_.empty())
    {
      const auto [i, k] = pieces_.back();
      pieces_.pop_back();
      if (k - i > 1)
      {
        const std::size_t j = best_[i * n + k];
        triangles.push_back({ rim[i], rim[j], rim[k] });
        pieces_.emplace_back(i, j);
        pieces_.emplace_back(j, k);
      }
    }
    return least_[n - 1];
  }

  double areaOf(const Triangle& t) const
  {
    const Point& p = surface_.vertices[t[0]];
    return norm(cross(minus(surface_.vertices[t[1]], p), minus(surface_.vertices[t[2]], p))) / 2;
  }

  const Surface& surface_;
  std::vector<double> least_; // area of the best filling of each piece of the rim
  std::vector<std::size_t> best_;
  std::vector<std::pair<std::size_t, std::size_t>> pieces_;
};

struct RimLoop
{
  std::vector<RimEdge> edges; // from the lowest vertex on
  double length = 0;          // levels
  Vector centre{};

  bool operator<(const RimLoop& other) const
  {
    return edges[0].from != other.edges[0].from ? edges[0].from < other.edges[0].from
                                                : edges[0].to < other.edges[0].to;
  }
};

RimLoop loopOf(const RimEdge* begin, const RimEdge* end, const Surface& surface)
{
  RimLoop loop;
  loop.edges.assign(begin, end);
  std::rotate(loop.edges.begin(),
    std::min_element(loop.edges.begin(), loop.edges.end(),
      [](const RimEdge& a, const RimEdge& b) { return a.from < b.from; }),
    loop.edges.end());
  for (const RimEdge& edge : loop.edges)
  {
    const Point& p = surface.vertices[edge.from];
    loop.length += norm(minus(surface.vertices[edge.to], p));
    for (std::size_t axis = 0; axis < 3; ++axis)
    {
      loop.centre[axis] += p[axis] / static_cast<double>(loop.edges.size());
    }
  }
  return loop;
}

// Whether most triangles around a hole run along its rim; those that fill it then run the other way.
bool runsAlong(const RimLoop& loop)
{
  int along = 0;
  for (const RimEdge& edge : loop.edges)
  {
    along += edge.along;
  }
  return along > 0;
}

std::int32_t boundaryOf(const RimLoop& loop, const Surface& surface)
{
  std::map<std::int32_t, std::size_t> edges;
  for (const RimEdge& edge : loop.edges)
  {
    ++edges[surface.boundary[edge.triangle]];
  }
  return std::max_element(edges.begin(), edges.end(), [](const auto& a, const auto& b) {
    return a.second < b.second;
  })->first;
}

// A hole and what closes it.
struct Filling
{
  RimLoop loop;
  Hole hole{};
  std::vector<Triangle> triangles = {};

  double area() const { return hole.width * loop.length / 4; }
};

void fill(const Surface& surface, const Meshlines& planes, Filling& filling)
{
  Hole& hole = filling.hole;
  for (const RimEdge& edge : filling.loop.edges)
  {
    hole.rim.push_back(edge.from);
  }
  std::vector<std::uint32_t> rim = hole.rim;
  if (runsAlong(filling.loop))
  {
    std::reverse(rim.begin(), rim.end());
  }
  hole.width = 4 * HoleFiller(surface).fill(rim, filling.triangles) / filling.loop.length;
  hole.leak = hole.width >= narrowestSide(planes, filling.loop.centre);
  hole.triangles = filling.triangles.size();
}

std::vector<Filling> fillingsOf(
  const Surface& surface, const SurfaceEdges& edges, const Meshlines& planes, Execution& execution)
{
  const std::vector<RimEdge> rims = findRims(edges);
  std::vector<RimLoop> loops;
  if (!rims.empty())
  {
    RimTracer(rims, surface.vertices.size())
      .forEachLoop([&](const RimEdge* begin, const RimEdge* end) {
        loops.push_back(loopOf(begin, end, surface));
      });
  }
  std::sort(loops.begin(), loops.end());
  std::vector<Filling> fillings;
  for (RimLoop& loop : loops)
  {
    fillings.push_back({ std::move(loop) });
  }
  execution.forEach(
    fillings.size(), 1, [&](std::size_t h, std::size_t) { fill(surface, planes, fillings[h]); });
  return fillings;
}

std::vector<Hole> append(std::vector<Filling> fillings, Surface& surface)
{
  std::vector<Hole> holes;
  for (Filling& filling : fillings)
  {
    const std::vector<Triangle>& triangles = filling.triangles;
    filling.hole.firstTriangle = surface.triangles.size();
    surface.triangles.insert(surface.triangles.end(), triangles.begin(), triangles.end());
    surface.boundary.resize(
      surface.triangles.size(), filling.hole.leak ? NoBoundary : boundaryOf(filling.loop, surface));
    holes.push_back(std::move(filling.hole));
  }
  return holes;
}

// Whether its rim is around a sheet, not in it: a lid would be about as large as what it is the rim of.
bool isAroundSheet(
  const Filling& filling, const Surface& surface, const std::vector<std::uint8_t>& isOfSheet)
{
  const std::uint32_t first = filling.hole.rim.front();
  if (first >= isOfSheet.size() || isOfSheet[first] == 0)
  {
    return false;
  }
  std::set<std::uint32_t> along;
  for (const RimEdge& edge : filling.loop.edges)
  {
    along.insert(edge.triangle);
  }
  const double beside = std::accumulate(along.begin(), along.end(), 0.,
    [&](double sum, std::uint32_t t) { return sum + areaOf(surface, t); });
  return filling.area() > LeastLid * beside;
}

}

std::vector<Hole> closeHoles(
  Surface& surface, const SurfaceEdges& edges, const Meshlines& planes, Execution& execution)
{
  return append(fillingsOf(surface, edges, planes, execution), surface);
}

std::vector<Hole> closeNarrowHoles(Surface& surface, double width,
  const std::vector<std::uint8_t>& isOfSheet, const Meshlines& planes, Execution& execution)
{
  std::vector<Filling> fillings =
    fillingsOf(surface, SurfaceEdges(surface, execution), planes, execution);
  const auto staysOpen = [&](const Filling& filling) {
    return filling.hole.width >= width || isAroundSheet(filling, surface, isOfSheet);
  };
  fillings.erase(std::remove_if(fillings.begin(), fillings.end(), staysOpen), fillings.end());
  return append(std::move(fillings), surface);
}

}
