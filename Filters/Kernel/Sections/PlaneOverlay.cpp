// SPDX-License-Identifier: BSD-3-Clause
#include "Sections/PlaneOverlay.h"

#include "Sections/OutlineFitting.h"
#include "Sections/PlaneBuckets.h"
#include "Sections/PlaneGraph.h"

#include <algorithm>
#include <limits>
#include <map>

namespace cartesian
{

namespace
{

constexpr std::uint32_t NoPoint = PlaneOverlay::NoPoint;
constexpr std::uint32_t NoEdge = ~std::uint32_t(0);
constexpr double Rounding = 1e-12; // of the sum of areas

// What is nearer to points and edges of a division is on them; what is on its outline only to those of the other's outline.
struct Reaches
{
  std::vector<double> ofPoints;
  std::vector<double> ofEdges;
  std::vector<bool> isOutlinePoint;
  std::vector<bool> isOutlineEdge;
};

std::uint32_t findEdge(const std::vector<PlaneEdge>& edges, std::uint32_t a, std::uint32_t b)
{
  const auto at =
    std::lower_bound(edges.begin(), edges.end(), std::array{ std::min(a, b), std::max(a, b) },
      [](const PlaneEdge& edge, const std::array<std::uint32_t, 2>& ends) {
        return std::array{ edge.from, edge.to } < ends;
      });
  return static_cast<std::uint32_t>(at - edges.begin());
}

// From a place to the nearest of a segment.
double distanceTo(const PlanePlace& a, const PlanePlace& b, const PlanePlace& p)
{
  return distance(between(a, b, std::clamp(footOn(a, b, p), 0.0, 1.0)), p);
}

// A part of the least distance from each point, and each edge, to what its polygons have besides.
Reaches reachesOf(const PlanePolygons& polygons, const std::vector<PlaneEdge>& edges)
{
  constexpr double Far = std::numeric_limits<double>::max();
  Reaches reaches{ std::vector<double>(polygons.points.size(), Far),
    std::vector<double>(edges.size(), Far), std::vector<bool>(polygons.points.size()),
    std::vector<bool>(edges.size()) };
  const auto lower = [](double& reach, double length) {
    reach = std::min(reach, PlaneOverlay::Nearby * length);
  };
  for (std::size_t p = 0; p < polygons.count(); ++p)
  {
    const std::size_t size = polygons.size(p);
    for (std::size_t i = 0; i < size; ++i)
    {
      const std::uint32_t a = polygons.corner(p, i);
      const std::uint32_t b = polygons.corner(p, i + 1);
      const std::uint32_t e = findEdge(edges, a, b);
      const double length = distance(polygons.points[a], polygons.points[b]);
      lower(reaches.ofPoints[a], length);
      lower(reaches.ofPoints[b], length);
      lower(reaches.ofEdges[e], length);
      for (std::size_t j = i + 2; j < i + size; ++j)
      {
        const std::uint32_t other = polygons.corner(p, j);
        const double away =
          distanceTo(polygons.points[a], polygons.points[b], polygons.points[other]);
        for (const std::uint32_t point : { a, b, other })
        {
          lower(reaches.ofPoints[point], away);
        }
        lower(reaches.ofEdges[e], away);
      }
    }
  }
  for (std::size_t e = 0; e < edges.size(); ++e)
  {
    reaches.ofEdges[e] = std::min(
      { reaches.ofEdges[e], reaches.ofPoints[edges[e].from], reaches.ofPoints[edges[e].to] });
  }
  for (std::size_t e = 0; e < edges.size(); ++e)
  {
    if (edges[e].isOutline())
    {
      reaches.isOutlineEdge[e] = true;
      reaches.isOutlinePoint[edges[e].from] = true;
      reaches.isOutlinePoint[edges[e].to] = true;
    }
  }
  return reaches;
}

// A vertex in the midst of an edge.
struct Inserted
{
  std::uint32_t edge;
  double at; // from its first end to its second: 0 to 1
  std::uint32_t vertex;
};

class Overlaying
{
public:
  Overlaying(const PlanePolygons& first, const PlanePolygons& second)
    : first_(first)
    , second_(second)
    , edges_{ edgesOf(first), edgesOf(second) }
    , reaches_{ reachesOf(first, edges_[0]), reachesOf(second, edges_[1]) }
    , nearPoints_(rangesOfPoints(first))
    , nearEdges_(rangesOfEdges(first, edges_[0]))
  {
  }

  PlaneOverlay run()
  {
    placePoints();
    for (std::uint32_t e = 0; e < edges_[1].size(); ++e)
    {
      route(e);
    }
    sortInserted();
    for (std::uint32_t e = 0; e < edges_[1].size(); ++e)
    {
      followFirst(routes_[e]);
    }
    listChains();
    const std::array sides{ sidesOf(first_, 0), sidesOf(second_, 1) };
    traceFaces(sides, result_);
    compareAreas(first_.count(), sides[0], 0);
    compareAreas(second_.count(), sides[1], 1);
    return std::move(result_);
  }

private:
  static std::vector<PlaneRange> rangesOfPoints(const PlanePolygons& polygons)
  {
    std::vector<PlaneRange> ranges;
    ranges.reserve(polygons.points.size());
    for (const PlanePlace& point : polygons.points)
    {
      ranges.push_back({ point, point });
    }
    return ranges;
  }

  static std::vector<PlaneRange> rangesOfEdges(
    const PlanePolygons& polygons, const std::vector<PlaneEdge>& edges)
  {
    std::vector<PlaneRange> ranges;
    ranges.reserve(edges.size());
    for (const PlaneEdge& edge : edges)
    {
      ranges.push_back(rangeOf(polygons.points[edge.from], polygons.points[edge.to]));
    }
    return ranges;
  }

  const PlanePlace& at(std::uint32_t vertex) const { return result_.vertices[vertex].at; }

  // --- Vertices

  // The first division's, then those of the second that move onto none of these.
  void placePoints()
  {
    for (std::uint32_t p = 0; p < first_.points.size(); ++p)
    {
      result_.vertices.push_back({ first_.points[p], { p, NoPoint } });
    }
    edgeOf_.assign(first_.points.size(), NoEdge);
    vertexOf_.assign(second_.points.size(), NoPoint);
    movePointsOntoPoints();
    for (std::uint32_t p = 0; p < second_.points.size(); ++p)
    {
      if (vertexOf_[p] == NoPoint)
      {
        movePointOntoEdge(p);
      }
    }
  }

  // Nearest ones first; each point takes one.
  void movePointsOntoPoints()
  {
    std::vector<std::pair<double, std::array<std::uint32_t, 2>>> pairs;
    for (std::uint32_t p = 0; p < second_.points.size(); ++p)
    {
      const PlanePlace& place = second_.points[p];
      PlaneRange range{ place, place };
      range.grow(reaches_[1].ofPoints[p]);
      for (const std::uint32_t other : nearPoints_.near(range))
      {
        const double away = distance(first_.points[other], place);
        if (reaches_[0].isOutlinePoint[other] == reaches_[1].isOutlinePoint[p] &&
          away <= std::min(reaches_[0].ofPoints[other], reaches_[1].ofPoints[p]))
        {
          pairs.push_back({ away, { other, p } });
        }
      }
    }
    std::sort(pairs.begin(), pairs.end());
    for (const auto& [away, points] : pairs)
    {
      std::uint32_t& taken = result_.vertices[points[0]].point[1];
      if (taken == NoPoint && vertexOf_[points[1]] == NoPoint)
      {
        taken = points[1];
        vertexOf_[points[1]] = points[0];
      }
    }
  }

  void movePointOntoEdge(std::uint32_t p)
  {
    const PlanePlace& place = second_.points[p];
    PlaneRange range{ place, place };
    range.grow(reaches_[1].ofPoints[p]);
    Inserted onto{ NoEdge, 0, addVertex(place, p) };
    double least = reaches_[1].ofPoints[p];
    for (const std::uint32_t e : nearEdges_.near(range))
    {
      const PlanePlace& a = first_.points[edges_[0][e].from];
      const PlanePlace& b = first_.points[edges_[0][e].to];
      const double foot = footOn(a, b, place);
      const double away = distance(between(a, b, foot), place);
      if (reaches_[0].isOutlineEdge[e] == reaches_[1].isOutlinePoint[p] && foot > 0 && foot < 1 &&
        away <= std::min(least, reaches_[0].ofEdges[e]))
      {
        least = away;
        onto.edge = e;
        onto.at = foot;
      }
    }
    vertexOf_[p] = onto.vertex;
    edgeOf_.back() = onto.edge;
    if (onto.edge != NoEdge)
    {
      result_.vertices.back().at = placeOn(onto);
      inserted_.push_back(onto);
    }
  }

  PlanePlace placeOn(const Inserted& inserted) const
  {
    const PlaneEdge& edge = edges_[0][inserted.edge];
    return between(first_.points[edge.from], first_.points[edge.to], inserted.at);
  }

  std::uint32_t addVertex(const PlanePlace& place, std::uint32_t pointOfSecond)
  {
    result_.vertices.push_back({ place, { NoPoint, pointOfSecond } });
    edgeOf_.push_back(NoEdge);
    return static_cast<std::uint32_t>(result_.vertices.size() - 1);
  }

  // --- The second division's edges

  void route(std::uint32_t e)
  {
    const PlaneEdge& edge = edges_[1][e];
    const std::vector<std::uint32_t> way = pointsOn(vertexOf_[edge.from], vertexOf_[edge.to], e);
    std::vector<std::uint32_t> all{ way[0] };
    for (std::size_t i = 0; i + 1 < way.size(); ++i)
    {
      // Two edges may have a part in common: it is always seen from the same end.
      const std::array ends{ std::min(way[i], way[i + 1]), std::max(way[i], way[i + 1]) };
      const auto [at, isNew] = crossings_.try_emplace(ends);
      if (isNew)
      {
        at->second = crossingsOf(ends[0], ends[1]);
      }
      const std::vector<std::uint32_t>& on = at->second;
      ends[0] == way[i] ? void(all.insert(all.end(), on.begin(), on.end()))
                        : void(all.insert(all.end(), on.rbegin(), on.rend()));
      all.push_back(way[i + 1]);
    }
    routes_.push_back(std::move(all));
  }

  // One vertex, the points of the first division that are on the way from there to another, and this.
  std::vector<std::uint32_t> pointsOn(std::uint32_t v, std::uint32_t w, std::uint32_t edge)
  {
    const double reach = reaches_[1].ofEdges[edge];
    const bool isOutline = reaches_[1].isOutlineEdge[edge];
    PlaneRange range = rangeOf(at(v), at(w));
    range.grow(reach);
    std::vector<std::pair<double, std::uint32_t>> found;
    for (const std::uint32_t p : nearPoints_.near(range))
    {
      const double foot = footOn(at(v), at(w), at(p));
      const double away = distance(between(at(v), at(w), foot), at(p));
      // Less near the ends, where other edges may be in between.
      const double most = 2 * reach * std::min(foot, 1 - foot);
      if (p != v && p != w && reaches_[0].isOutlinePoint[p] == isOutline && foot > 0 && foot < 1 &&
        away <= std::min(most, reaches_[0].ofPoints[p]))
      {
        found.emplace_back(foot, p);
      }
    }
    std::sort(found.begin(), found.end());
    std::vector<std::uint32_t> way{ v };
    for (const auto& [foot, p] : found)
    {
      way.push_back(p);
    }
    way.push_back(w);
    return way;
  }

  bool isOn(std::uint32_t vertex, std::uint32_t e) const
  {
    return vertex == edges_[0][e].from || vertex == edges_[0][e].to || edgeOf_[vertex] == e;
  }

  // New vertices where the way crosses the first division's edges.
  std::vector<std::uint32_t> crossingsOf(std::uint32_t v, std::uint32_t w)
  {
    const PlanePlace from = at(v);
    const PlanePlace to = at(w);
    std::vector<std::pair<double, Inserted>> crossings; // by how far on the way
    for (const std::uint32_t e : nearEdges_.near(rangeOf(from, to)))
    {
      const PlanePlace& a = first_.points[edges_[0][e].from];
      const PlanePlace& b = first_.points[edges_[0][e].to];
      const double atFrom = turnOf(a, b, from);
      const double atTo = turnOf(a, b, to);
      const double atA = turnOf(from, to, a);
      const double atB = turnOf(from, to, b);
      if (!isOn(v, e) && !isOn(w, e) && (atFrom > 0) != (atTo > 0) && (atA > 0) != (atB > 0))
      {
        crossings.push_back({ atFrom / (atFrom - atTo), { e, atA / (atA - atB), NoPoint } });
      }
    }
    std::sort(crossings.begin(), crossings.end(), [](const auto& a, const auto& b) {
      return a.first != b.first ? a.first < b.first : a.second.edge < b.second.edge;
    });
    std::vector<std::uint32_t> all;
    for (auto& [far, crossing] : crossings)
    {
      crossing.vertex = addVertex(placeOn(crossing), NoPoint);
      edgeOf_.back() = crossing.edge;
      inserted_.push_back(crossing);
      all.push_back(crossing.vertex);
    }
    return all;
  }

  // --- What edges consist of

  void sortInserted()
  {
    std::sort(inserted_.begin(), inserted_.end(), [](const Inserted& a, const Inserted& b) {
      return a.edge != b.edge ? a.edge < b.edge : a.at != b.at ? a.at < b.at : a.vertex < b.vertex;
    });
    placeOf_.assign(result_.vertices.size(), 0);
    firstInserted_.assign(edges_[0].size() + 1, 0);
    for (std::size_t i = 0; i < inserted_.size(); ++i)
    {
      placeOf_[inserted_[i].vertex] = i;
      firstInserted_[inserted_[i].edge + 1] = i + 1;
    }
    for (std::size_t e = 1; e < firstInserted_.size(); ++e)
    {
      firstInserted_[e] = std::max(firstInserted_[e], firstInserted_[e - 1]);
    }
  }

  // The edge of the first division that two vertices are on, or none.
  std::uint32_t edgeOfBoth(std::uint32_t v, std::uint32_t w) const
  {
    for (const std::uint32_t e : { edgeOf_[v], edgeOf_[w] })
    {
      if (e != NoEdge)
      {
        return isOn(v, e) && isOn(w, e) ? e : NoEdge;
      }
    }
    const std::uint32_t e = std::max(v, w) < first_.points.size()
      ? findEdge(edges_[0], v, w)
      : static_cast<std::uint32_t>(edges_[0].size());
    return e < edges_[0].size() && isOn(v, e) && isOn(w, e) ? e : NoEdge;
  }

  // Where a way leads along an edge of the first division, it has all that is on it.
  void followFirst(std::vector<std::uint32_t>& way) const
  {
    std::vector<std::uint32_t> all{ way[0] };
    for (std::size_t i = 0; i + 1 < way.size(); ++i)
    {
      const std::uint32_t e = edgeOfBoth(way[i], way[i + 1]);
      if (e != NoEdge)
      {
        const std::size_t begin = rankOn(e, way[i]);
        const std::size_t end = rankOn(e, way[i + 1]);
        for (std::size_t r = begin; r + 1 < end; ++r)
        {
          all.push_back(inserted_[r].vertex);
        }
        for (std::size_t r = begin; r > end + 1; --r)
        {
          all.push_back(inserted_[r - 2].vertex);
        }
      }
      all.push_back(way[i + 1]);
    }
    way = std::move(all);
  }

  // Of the vertices on an edge: the next that was inserted, for the edge's first end; else one more than its own place.
  std::size_t rankOn(std::uint32_t e, std::uint32_t vertex) const
  {
    return vertex == edges_[0][e].from ? firstInserted_[e]
      : vertex == edges_[0][e].to      ? firstInserted_[e + 1] + 1
                                       : placeOf_[vertex] + 1;
  }

  void listChains()
  {
    for (std::uint32_t e = 0; e < edges_[0].size(); ++e)
    {
      PlaneOverlay::Chain chain{ { edges_[0][e].from, edges_[0][e].to }, {} };
      for (std::size_t i = firstInserted_[e]; i < firstInserted_[e + 1]; ++i)
      {
        chain.vertices.push_back(inserted_[i].vertex);
      }
      result_.chains[0].push_back(std::move(chain));
    }
    for (std::uint32_t e = 0; e < edges_[1].size(); ++e)
    {
      const std::vector<std::uint32_t>& way = routes_[e];
      result_.chains[1].push_back(
        { { edges_[1][e].from, edges_[1][e].to }, { way.begin() + 1, way.end() - 1 } });
    }
  }

  // Each edge of a division in either direction.
  std::vector<SidedEdge> sidesOf(const PlanePolygons& division, std::size_t k) const
  {
    std::vector<SidedEdge> sides;
    sides.reserve(2 * division.corners.size());
    for (std::size_t e = 0; e < edges_[k].size(); ++e)
    {
      const PlaneOverlay::Chain& chain = result_.chains[k][e];
      const auto vertexOf = [&](std::uint32_t point) { return k == 0 ? point : vertexOf_[point]; };
      std::uint32_t from = vertexOf(chain.ends[0]);
      const auto addTo = [&](std::uint32_t to) {
        sides.push_back({ from, to, edges_[k][e].polygons[0] });
        sides.push_back({ to, from, edges_[k][e].polygons[1] });
        from = to;
      };
      std::for_each(chain.vertices.begin(), chain.vertices.end(), addTo);
      addTo(vertexOf(chain.ends[1]));
    }
    return sides;
  }

  // Where a polygon is not what it was divided into, points and edges have moved across others.
  void compareAreas(std::size_t count, const std::vector<SidedEdge>& sides, std::size_t k)
  {
    std::vector<double> areas(count);
    std::vector<std::uint32_t> anyVertex(count);
    const PlanePlace origin = at(0);
    double all = 0;
    for (const SidedEdge& side : sides)
    {
      if (side.polygon != NoPolygon)
      {
        areas[side.polygon] += turnOf(origin, at(side.from), at(side.to)) / 2;
        anyVertex[side.polygon] = side.from;
      }
    }
    for (std::size_t p = 0; p < result_.polygons.size(); ++p)
    {
      const double own = areaOf(p);
      areas[result_.polygons[p].of[k]] -= own;
      all += own;
    }
    for (std::size_t polygon = 0; polygon < count; ++polygon)
    {
      if (std::abs(areas[polygon]) > std::max(Rounding * all, result_.unmatched))
      {
        result_.unmatched = std::abs(areas[polygon]);
        result_.unmatchedAt = at(anyVertex[polygon]);
      }
    }
  }

  double areaOf(std::size_t polygon) const
  {
    const std::size_t first = result_.polygons[polygon].firstCorner;
    const std::size_t end = polygon + 1 < result_.polygons.size()
      ? result_.polygons[polygon + 1].firstCorner
      : result_.corners.size();
    double area = 0;
    for (std::size_t i = first + 1; i + 1 < end; ++i)
    {
      area +=
        turnOf(at(result_.corners[first]), at(result_.corners[i]), at(result_.corners[i + 1]));
    }
    return area / 2;
  }

  const PlanePolygons& first_;
  const PlanePolygons& second_;
  std::array<std::vector<PlaneEdge>, 2> edges_;
  std::array<Reaches, 2> reaches_;
  PlaneBuckets nearPoints_; // of the first division
  PlaneBuckets nearEdges_;
  std::vector<std::uint32_t> vertexOf_; // of each point of the second
  std::vector<std::uint32_t>
    edgeOf_; // of each vertex: the first division's edge in whose midst it is
  std::map<std::array<std::uint32_t, 2>, std::vector<std::uint32_t>>
    crossings_; // between two vertices, the lower of which is the first
  std::vector<Inserted> inserted_;
  std::vector<std::size_t> firstInserted_;         // of each edge, and the end
  std::vector<std::size_t> placeOf_;               // of each vertex among these
  std::vector<std::vector<std::uint32_t>> routes_; // of each edge of the second: vertices
  PlaneOverlay result_;
};

// Of the second division's points, those that it had; its edges as they were.
PlaneOverlay withoutInserted(
  const FittedOutline& fitted, const PlanePolygons& second, PlaneOverlay result)
{
  std::vector<std::uint32_t> vertexOf(fitted.polygons.points.size(), NoPoint);
  for (std::uint32_t v = 0; v < result.vertices.size(); ++v)
  {
    std::uint32_t& point = result.vertices[v].point[1];
    if (point != NoPoint)
    {
      vertexOf[point] = v;
      point = point < second.points.size() ? point : NoPoint;
    }
  }
  std::map<std::array<std::uint32_t, 2>, std::vector<std::uint32_t>> parts;
  for (PlaneOverlay::Chain& chain : result.chains[1])
  {
    parts[chain.ends] = std::move(chain.vertices);
  }
  for (const auto& [ends, points] : fitted.inserted)
  {
    std::vector<std::uint32_t> all;
    std::uint32_t from = ends[0];
    const auto addTo = [&](std::uint32_t to) {
      const auto part = parts.extract({ std::min(from, to), std::max(from, to) });
      const std::vector<std::uint32_t>& own = part.mapped();
      from < to ? void(all.insert(all.end(), own.begin(), own.end()))
                : void(all.insert(all.end(), own.rbegin(), own.rend()));
      from = to;
    };
    for (const std::uint32_t point : points)
    {
      addTo(point);
      all.push_back(vertexOf[point]);
    }
    addTo(ends[1]);
    parts[ends] = std::move(all);
  }
  result.chains[1].clear();
  for (auto& [ends, vertices] : parts)
  {
    result.chains[1].push_back({ ends, std::move(vertices) });
  }
  return result;
}

}

PlaneOverlay overlay(const PlanePolygons& first, const PlanePolygons& second)
{
  const FittedOutline fitted = fitOutline(first, second);
  return withoutInserted(fitted, second, Overlaying(first, fitted.polygons).run());
}

}
