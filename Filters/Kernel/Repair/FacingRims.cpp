// SPDX-License-Identifier: BSD-3-Clause
#include "Repair/FacingRims.h"

#include "Repair/TriangleTree.h"

#include <algorithm>
#include <cmath>
#include <numeric>

namespace cartesian
{

namespace
{

// The cosine of half the angle of the cone that an edge looks into, and of the largest angle between what two that face each other look
// against: 66 degrees, so that the corners of a frame see those of a lid, but not its sides each other.
constexpr double Ahead = 0.4;

// The part of the reach that is searched first, then twice as much, and so on: it only takes time.
constexpr double FirstReach = 1. / 16;

constexpr std::size_t EdgesAChunk = 64;

class Looking
{
public:
  Looking(const Surface& surface, const FacingRims& rims, double widest, Execution& execution)
    : rims_(rims)
    , widest_(widest)
    , away_(rims.edges())
    , tree_(linesOf(surface, rims), allOf(rims), execution)
  {
    for (std::size_t e = 0; e < rims.edges(); ++e)
    {
      away_[e] = awayFromTriangle(surface, e);
    }
    for (std::size_t e = 0; e < rims.edges(); ++e)
    {
      awayAtStart_.push_back(unit(plus(away_[e], away_[rims.before(e)])));
    }
  }

  // Where the edge looks, or else both edges at its end together: the edges of a jagged rim look along it.
  std::optional<RimFoot> footOf(std::size_t e, std::size_t end) const
  {
    const std::size_t start = end == 0 ? e : rims_.next(e);
    const std::optional<RimFoot> foot = footAt(e, nearest(start, away_[e]));
    return foot ? foot : footAt(e, nearest(start, awayAtStart_[start]));
  }

private:
  struct Seen
  {
    double distance = HUGE_VAL;
    std::size_t edge = 0;
    double along = 0;
  };

  // Triangles without area, one an edge.
  static Surface linesOf(const Surface& surface, const FacingRims& rims)
  {
    Surface lines;
    lines.vertices = surface.vertices;
    for (std::size_t e = 0; e < rims.edges(); ++e)
    {
      lines.triangles.push_back({ rims.edge(e).from, rims.edge(e).to, rims.edge(e).to });
    }
    return lines;
  }

  static std::vector<std::uint32_t> allOf(const FacingRims& rims)
  {
    std::vector<std::uint32_t> all(rims.edges());
    std::iota(all.begin(), all.end(), 0U);
    return all;
  }

  // In the plane of its triangle, of length 1; 0: it has no area.
  Vector awayFromTriangle(const Surface& surface, std::size_t e) const
  {
    const RimEdge& edge = rims_.edge(e);
    const auto& corners = surface.triangles[edge.triangle];
    const auto opposite = *std::find_if(corners.begin(), corners.end(),
      [&](std::uint32_t vertex) { return vertex != edge.from && vertex != edge.to; });
    return unit(acrossFrom(toVector(surface.vertices[opposite]), e));
  }

  // From a place to the line of an edge.
  Vector acrossFrom(const Vector& place, std::size_t e) const
  {
    const Vector way = rims_.way(e);
    const Vector to = minus(rims_.from(e), place);
    return minus(to, scaled(way, dot(way, to) / dot(way, way)));
  }

  static bool isAhead(const Vector& away, const Vector& to)
  {
    return dot(away, to) > Ahead * norm(to);
  }

  // Whether something that looks `away` at a place of an edge is looked at from there; at a vertex, from either edge or both together.
  bool looksBack(std::size_t e, double along, const Vector& away, const Vector& to) const
  {
    const auto looks = [&](const Vector& back) {
      return isAhead(back, scaled(to, -1)) && dot(back, away) < -Ahead;
    };
    const std::size_t next = rims_.next(e);
    return looks(away_[e]) ||
      (along == 0 && (looks(away_[rims_.before(e)]) || looks(awayAtStart_[e]))) ||
      (along == 1 && (looks(away_[next]) || looks(awayAtStart_[next])));
  }

  // From the start of an edge.
  Seen nearest(std::size_t start, const Vector& away) const
  {
    const Vector place = rims_.from(start);
    const double most = widest_ / Ahead;
    for (double reach = FirstReach * most;; reach *= 2)
    {
      const Seen seen = nearestWithin(std::min(reach, most), place, away);
      if (seen.distance < HUGE_VAL || reach >= most)
      {
        return seen;
      }
    }
  }

  Seen nearestWithin(double reach, const Vector& place, const Vector& away) const
  {
    Seen best;
    const Vector around{ reach, reach, reach };
    tree_.forEachWithin(minus(place, around), plus(place, around), [&](std::uint32_t other) {
      const Vector way = rims_.way(other);
      const double along =
        std::clamp(dot(way, minus(place, rims_.from(other))) / dot(way, way), 0., 1.);
      const Vector to = minus(plus(rims_.from(other), scaled(way, along)), place);
      const double distance = norm(to);
      const bool isNearer =
        distance < best.distance || (distance == best.distance && other < best.edge);
      if (isNearer && distance <= reach && isAhead(away, to) && looksBack(other, along, away, to))
      {
        best = { distance, other, along };
      }
    });
    return best;
  }

  std::optional<RimFoot> footAt(std::size_t e, const Seen& seen) const
  {
    if (seen.distance == HUGE_VAL || rims_.loopOf(seen.edge) == rims_.loopOf(e))
    {
      return {};
    }
    // At a corner of a lid, that of its frame is farther away than their sides.
    const bool isAtVertex = seen.along == 0 || seen.along == 1;
    const Vector foot = plus(rims_.from(seen.edge), scaled(rims_.way(seen.edge), seen.along));
    const double across =
      isAtVertex ? std::min(seen.distance, norm(acrossFrom(foot, e))) : seen.distance;
    return across <= widest_ ? std::optional(RimFoot{ seen.edge, seen.along, across })
                             : std::nullopt;
  }

  const FacingRims& rims_;
  double widest_;
  std::vector<Vector> away_;        // of each edge
  std::vector<Vector> awayAtStart_; // of both edges where it starts
  TriangleTree tree_;
};

}

FacingRims::FacingRims(const Surface& surface, double widest, Execution& execution)
  : surface_(surface)
  , starts_{ 0 }
  , lengths_{ 0 }
{
  for (const std::vector<RimEdge>& loop : rimLoopsOf(surface, SurfaceEdges(surface, execution)))
  {
    edges_.insert(edges_.end(), loop.begin(), loop.end());
    loops_.resize(edges_.size(), starts_.size() - 1);
    starts_.push_back(edges_.size());
  }
  feet_.resize(2 * edges_.size());
  if (edges_.empty())
  {
    return;
  }
  for (std::size_t e = 0; e < edges_.size(); ++e)
  {
    lengths_.push_back(lengths_.back() + norm(way(e)));
  }
  look(widest, execution);
  followNeighbours();
}

void FacingRims::look(double widest, Execution& execution)
{
  const Looking looking(surface_, *this, widest, execution);
  execution.forEach(edges_.size(), EdgesAChunk, [&](std::size_t begin, std::size_t end) {
    for (std::size_t e = begin; e < end; ++e)
    {
      feet_[2 * e] = looking.footOf(e, 0);
      feet_[2 * e + 1] = looking.footOf(e, 1);
    }
  });
}

void FacingRims::followNeighbours()
{
  const std::vector<std::optional<RimFoot>> own = feet_;
  for (std::size_t e = 0; e < edges_.size(); ++e)
  {
    if (!own[2 * e])
    {
      feet_[2 * e] = own[2 * before(e) + 1];
    }
    if (!own[2 * e + 1])
    {
      feet_[2 * e + 1] = own[2 * next(e)];
    }
  }
}

double FacingRims::lengthTo(std::size_t e, const RimFoot& foot) const
{
  const double to =
    lengths_[foot.edge] + foot.along * (lengths_[foot.edge + 1] - lengths_[foot.edge]);
  const double length = to - lengths_[e];
  return length < 0 ? length + lengthOf(loops_[e]) : length;
}

}
