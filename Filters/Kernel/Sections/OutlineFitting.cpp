// SPDX-License-Identifier: BSD-3-Clause
#include "Sections/OutlineFitting.h"

#include "Sections/PlaneBuckets.h"

#include <algorithm>
#include <limits>

namespace cartesian
{

namespace
{

constexpr std::uint32_t None = ~std::uint32_t(0);

// The edges and points of a division that have nothing beyond.
struct Outline
{
  std::vector<PlaneEdge> edges;
  std::vector<std::uint32_t> points; // ascending
  std::vector<double> reaches;       // of each: what is nearer may be the same
  std::vector<PlanePlace> ways;      // of each: along its edges, with the division to the left

  std::size_t placeOf(std::uint32_t point) const
  {
    return static_cast<std::size_t>(
      std::lower_bound(points.begin(), points.end(), point) - points.begin());
  }
};

// Along an edge of an outline, with the division to the left.
PlanePlace wayAlong(const PlaneEdge& edge, const std::vector<PlanePlace>& points)
{
  const bool isForward = edge.polygons[0] != NoPolygon;
  const PlanePlace& a = points[isForward ? edge.from : edge.to];
  const PlanePlace& b = points[isForward ? edge.to : edge.from];
  const double length = distance(a, b);
  return length > 0 ? PlanePlace{ (b[0] - a[0]) / length, (b[1] - a[1]) / length } : PlanePlace{};
}

// Both sides of a thin gap in a division are near each other, but lead opposite ways.
bool leadsAlike(const PlanePlace& a, const PlanePlace& b)
{
  return a[0] * b[0] + a[1] * b[1] >= 0;
}

double reachOf(const PlaneEdge& edge, const std::vector<PlanePlace>& points)
{
  return OutlineFitting::Nearby * distance(points[edge.from], points[edge.to]);
}

Outline outlineOf(const PlanePolygons& polygons)
{
  Outline outline;
  for (const PlaneEdge& edge : edgesOf(polygons))
  {
    if (edge.isOutline())
    {
      outline.edges.push_back(edge);
      outline.points.insert(outline.points.end(), { edge.from, edge.to });
    }
  }
  std::sort(outline.points.begin(), outline.points.end());
  outline.points.erase(
    std::unique(outline.points.begin(), outline.points.end()), outline.points.end());
  outline.reaches.resize(outline.points.size());
  outline.ways.resize(outline.points.size());
  for (const PlaneEdge& edge : outline.edges)
  {
    const PlanePlace along = wayAlong(edge, polygons.points);
    for (const std::uint32_t end : { edge.from, edge.to })
    {
      const std::size_t i = outline.placeOf(end);
      outline.reaches[i] = std::max(outline.reaches[i], reachOf(edge, polygons.points));
      outline.ways[i] = { outline.ways[i][0] + along[0], outline.ways[i][1] + along[1] };
    }
  }
  return outline;
}

// With what is near to them.
std::vector<PlaneRange> rangesOf(
  const std::vector<PlaneEdge>& edges, const std::vector<PlanePlace>& points)
{
  std::vector<PlaneRange> ranges;
  ranges.reserve(edges.size());
  for (const PlaneEdge& edge : edges)
  {
    ranges.push_back(rangeOf(points[edge.from], points[edge.to]));
    ranges.back().grow(reachOf(edge, points));
  }
  return ranges;
}

std::vector<PlaneRange> rangesOf(
  const std::vector<std::uint32_t>& which, const std::vector<PlanePlace>& points)
{
  std::vector<PlaneRange> ranges;
  ranges.reserve(which.size());
  for (const std::uint32_t p : which)
  {
    ranges.push_back({ points[p], points[p] });
  }
  return ranges;
}

PlaneRange around(const PlanePlace& place, double reach)
{
  PlaneRange range{ place, place };
  range.grow(reach);
  return range;
}

// On an edge, from its first end to its second: 0 to 1.
struct PlaceOnEdge
{
  std::uint32_t edge = None;
  double at = 0;
};

class Fitting
{
public:
  Fitting(const PlanePolygons& first, const PlanePolygons& second)
    : first_(first)
    , second_(second)
    , outlines_{ outlineOf(first), outlineOf(second) }
    , ways_(second.points.size())
    , insertedOn_(outlines_[1].edges.size())
  {
  }

  FittedOutline run()
  {
    movePoints();
    insertPoints();
    moveInner();
    FittedOutline result;
    result.polygons = second_;
    for (std::size_t p = 0; p < ways_.size(); ++p)
    {
      PlanePlace& at = result.polygons.points[p];
      at = { at[0] + ways_[p][0], at[1] + ways_[p][1] };
    }
    for (const std::uint32_t p : exact_)
    {
      result.polygons.points[p] = first_.points[targets_[p]];
    }
    insertInto(result);
    return result;
  }

private:
  // The nearest place on some edges, within reach of the place or of the edge, not at their ends.
  static PlaceOnEdge nearestOn(const std::vector<PlaneEdge>& edges,
    const std::vector<PlanePlace>& points, PlaneBuckets& near, const PlanePlace& place,
    const PlanePlace& way, double reach)
  {
    PlaceOnEdge nearest;
    double least = std::numeric_limits<double>::max();
    for (const std::uint32_t e : near.near(around(place, reach)))
    {
      const PlanePlace& a = points[edges[e].from];
      const PlanePlace& b = points[edges[e].to];
      const double foot = footOn(a, b, place);
      const double away = distance(between(a, b, foot), place);
      if (foot > 0 && foot < 1 && away < least && leadsAlike(wayAlong(edges[e], points), way) &&
        away <= std::max(reach, reachOf(edges[e], points)))
      {
        least = away;
        nearest = { e, foot };
      }
    }
    return nearest;
  }

  void movePoints()
  {
    targets_.assign(second_.points.size(), None);
    isTaken_.assign(first_.points.size(), false);
    pairPoints();
    PlaneBuckets near(rangesOf(outlines_[0].edges, first_.points));
    const Outline& own = outlines_[1];
    for (std::size_t i = 0; i < own.points.size(); ++i)
    {
      const std::uint32_t p = own.points[i];
      const PlanePlace& place = second_.points[p];
      if (targets_[p] != None)
      {
        const PlanePlace& to = first_.points[targets_[p]];
        ways_[p] = { to[0] - place[0], to[1] - place[1] };
        exact_.push_back(p);
        continue;
      }
      const PlaceOnEdge on =
        nearestOn(outlines_[0].edges, first_.points, near, place, own.ways[i], own.reaches[i]);
      if (on.edge != None)
      {
        const PlaneEdge& edge = outlines_[0].edges[on.edge];
        const PlanePlace to = between(first_.points[edge.from], first_.points[edge.to], on.at);
        ways_[p] = { to[0] - place[0], to[1] - place[1] };
      }
    }
  }

  // Nearest ones first.
  void pairPoints()
  {
    PlaneBuckets near(rangesOf(outlines_[0].points, first_.points));
    std::vector<std::pair<double, std::array<std::uint32_t, 2>>> pairs;
    const Outline& own = outlines_[1];
    for (std::size_t i = 0; i < own.points.size(); ++i)
    {
      const PlanePlace& place = second_.points[own.points[i]];
      for (const std::uint32_t j : near.near(around(place, own.reaches[i])))
      {
        const std::uint32_t other = outlines_[0].points[j];
        const double away = distance(first_.points[other], place);
        if (away <= std::min(own.reaches[i], outlines_[0].reaches[j]) &&
          leadsAlike(own.ways[i], outlines_[0].ways[j]))
        {
          pairs.push_back({ away, { other, own.points[i] } });
        }
      }
    }
    std::sort(pairs.begin(), pairs.end());
    for (const auto& [away, points] : pairs)
    {
      if (!isTaken_[points[0]] && targets_[points[1]] == None)
      {
        isTaken_[points[0]] = true;
        targets_[points[1]] = points[0];
      }
    }
  }

  // Points of the first outline that no point has moved to, into the moved edges of the second.
  void insertPoints()
  {
    std::vector<PlanePlace> moved = second_.points;
    for (const std::uint32_t p : outlines_[1].points)
    {
      moved[p] = { moved[p][0] + ways_[p][0], moved[p][1] + ways_[p][1] };
    }
    PlaneBuckets near(rangesOf(outlines_[1].edges, moved));
    for (std::size_t i = 0; i < outlines_[0].points.size(); ++i)
    {
      const std::uint32_t p = outlines_[0].points[i];
      if (isTaken_[p])
      {
        continue;
      }
      const PlaceOnEdge on = nearestOn(outlines_[1].edges, moved, near, first_.points[p],
        outlines_[0].ways[i], outlines_[0].reaches[i]);
      if (on.edge != None)
      {
        insertedOn_[on.edge].emplace_back(on.at, p);
      }
    }
    for (auto& inserted : insertedOn_)
    {
      std::sort(inserted.begin(), inserted.end());
    }
  }

  // How a place on an edge of the second outline moves: as its ends and the points between do.
  PlanePlace wayAt(const PlaceOnEdge& on) const
  {
    const PlaneEdge& edge = outlines_[1].edges[on.edge];
    const PlanePlace& a = second_.points[edge.from];
    const PlanePlace& b = second_.points[edge.to];
    PlanePlace wayBefore = ways_[edge.from];
    PlanePlace wayBehind = ways_[edge.to];
    double before = 0;
    double behind = 1;
    for (const auto& [at, point] : insertedOn_[on.edge])
    {
      const PlanePlace from = between(a, b, at);
      const PlanePlace way{ first_.points[point][0] - from[0], first_.points[point][1] - from[1] };
      if (at <= on.at)
      {
        before = at;
        wayBefore = way;
      }
      else
      {
        behind = at;
        wayBehind = way;
        break;
      }
    }
    return between(
      wayBefore, wayBehind, behind > before ? (on.at - before) / (behind - before) : 0);
  }

  double longestWay() const
  {
    double longest = 0;
    for (std::uint32_t e = 0; e < outlines_[1].edges.size(); ++e)
    {
      const PlaneEdge& edge = outlines_[1].edges[e];
      longest = std::max({ longest, distance({}, ways_[edge.from]), distance({}, ways_[edge.to]) });
      for (const auto& [at, point] : insertedOn_[e])
      {
        longest = std::max(longest, distance({}, wayAt({ e, at })));
      }
    }
    return longest;
  }

  // Points near the outline, as the nearest place on it does, less with distance.
  void moveInner()
  {
    const double fade = OutlineFitting::Fade * longestWay();
    if (fade == 0)
    {
      return;
    }
    const Outline& own = outlines_[1];
    PlaneBuckets near(rangesOf(own.edges, second_.points));
    for (std::uint32_t p = 0; p < second_.points.size(); ++p)
    {
      if (std::binary_search(own.points.begin(), own.points.end(), p))
      {
        continue;
      }
      const PlanePlace& place = second_.points[p];
      double least = fade;
      PlaceOnEdge nearest;
      for (const std::uint32_t e : near.near(around(place, fade)))
      {
        const PlanePlace& a = second_.points[own.edges[e].from];
        const PlanePlace& b = second_.points[own.edges[e].to];
        const double at = std::clamp(footOn(a, b, place), 0.0, 1.0);
        const double away = distance(between(a, b, at), place);
        if (away < least)
        {
          least = away;
          nearest = { e, at };
        }
      }
      if (nearest.edge != None)
      {
        ways_[p] = between({}, wayAt(nearest), 1 - least / fade);
      }
    }
  }

  void insertInto(FittedOutline& result) const
  {
    PlanePolygons& all = result.polygons;
    for (std::size_t e = 0; e < insertedOn_.size(); ++e)
    {
      const PlaneEdge& edge = outlines_[1].edges[e];
      for (const auto& [at, point] : insertedOn_[e])
      {
        result.inserted[{ edge.from, edge.to }].push_back(
          static_cast<std::uint32_t>(all.points.size()));
        all.points.push_back(first_.points[point]);
      }
    }
    if (result.inserted.empty())
    {
      return;
    }
    PlanePolygons divided;
    divided.points = std::move(all.points);
    for (std::size_t p = 0; p < second_.count(); ++p)
    {
      for (std::size_t i = 0; i < second_.size(p); ++i)
      {
        const std::uint32_t a = second_.corner(p, i);
        const std::uint32_t b = second_.corner(p, i + 1);
        divided.corners.push_back(a);
        const auto on = result.inserted.find({ std::min(a, b), std::max(a, b) });
        if (on != result.inserted.end())
        {
          const std::vector<std::uint32_t>& points = on->second;
          a < b
            ? void(divided.corners.insert(divided.corners.end(), points.begin(), points.end()))
            : void(divided.corners.insert(divided.corners.end(), points.rbegin(), points.rend()));
        }
      }
      divided.firstCorner.push_back(divided.corners.size());
    }
    all = std::move(divided);
  }

  const PlanePolygons& first_;
  const PlanePolygons& second_;
  std::array<Outline, 2> outlines_;
  std::vector<std::uint32_t> targets_; // of each point of the second: one of the first, or None
  std::vector<bool> isTaken_;          // of each point of the first
  std::vector<std::uint32_t> exact_;   // points with a target
  std::vector<PlanePlace> ways_;       // of each point of the second
  std::vector<std::vector<std::pair<double, std::uint32_t>>>
    insertedOn_; // of each edge of the second outline: places and points of the first
};

}

FittedOutline fitOutline(const PlanePolygons& first, const PlanePolygons& second)
{
  return Fitting(first, second).run();
}

}
