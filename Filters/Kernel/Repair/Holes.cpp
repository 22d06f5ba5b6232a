// SPDX-License-Identifier: BSD-3-Clause
#include "Repair/Holes.h"

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
      area += areaOf(surface_, triangles.back());
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
          const double area = least_[i * n + j] + least_[j * n + k] +
            areaOf(surface_, Triangle{ rim[i], rim[j], rim[k] });
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
};

RimLoop loopOf(std::vector<RimEdge> edges, const Surface& surface)
{
  RimLoop loop;
  loop.edges = std::move(edges);
  loop.length = lengthOf(surface, loop.edges);
  for (const RimEdge& edge : loop.edges)
  {
    const Point& p = surface.vertices[edge.from];
    for (std::size_t axis = 0; axis < 3; ++axis)
    {
      loop.centre[axis] += p[axis] / static_cast<double>(loop.edges.size());
    }
  }
  return loop;
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
  hole.width = 4 * fillRim(surface, filling.loop.edges, filling.triangles) / filling.loop.length;
  hole.leak = hole.width >= narrowestSide(planes, filling.loop.centre);
  hole.triangles = filling.triangles.size();
}

std::vector<Filling> fillingsOf(
  const Surface& surface, const SurfaceEdges& edges, const Meshlines& planes, Execution& execution)
{
  std::vector<Filling> fillings;
  for (std::vector<RimEdge>& rim : rimLoopsOf(surface, edges))
  {
    fillings.push_back({ loopOf(std::move(rim), surface) });
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

double fillRim(
  const Surface& surface, const std::vector<RimEdge>& loop, std::vector<Triangle>& triangles)
{
  std::vector<std::uint32_t> rim;
  int along = 0;
  for (const RimEdge& edge : loop)
  {
    rim.push_back(edge.from);
    along += edge.along;
  }
  if (along > 0)
  {
    std::reverse(rim.begin(), rim.end());
  }
  return HoleFiller(surface).fill(rim, triangles);
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
