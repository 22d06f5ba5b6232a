// SPDX-License-Identifier: BSD-3-Clause
#include "Repair/Cracks.h"

#include "Base/DisjointSets.h"
#include "Repair/EdgePoints.h"
#include "Repair/OpenRims.h"
#include "Repair/TrianglePlane.h"
#include "Repair/TriangleTree.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <set>
#include <tuple>

namespace cartesian
{

namespace
{

// What is nearer than this along a rim, by the width of cracks there, is the same side of a crack.
constexpr double SameSide = 4;

// A rim is straight from one corner to another if it is not longer by this part than the way.
constexpr double Straight = 1e-9;

bool isIn(const std::vector<std::uint32_t>& sorted, std::uint32_t vertex)
{
  return std::binary_search(sorted.begin(), sorted.end(), vertex);
}

// An edge, or a part of one between two corners that lie on it: the lower and the upper corner.
using Part = std::array<std::uint32_t, 2>;

class CrackJoiner
{
public:
  CrackJoiner(Surface& surface, const Meshlines& planes, const CrackSpec& spec, int depth,
    Execution& execution)
    : surface_(surface)
    , planes_(planes)
    , width_(spec.width / surface.lattice.step())
    , partOfBox_(std::ldexp(CrackSpec::PartOfBox, -depth))
    , execution_(execution)
  {
  }

  JoinedCracks join()
  {
    const std::vector<OpenEdge> open = openEdgesOf(surface_, execution_);
    if (open.empty())
    {
      return {};
    }
    const OpenRims given(surface_, open);
    findMoves(given);
    findPoints(OpenRims(surface_, movedEdges(open)), given);
    const std::vector<Part> met = keepThoseOfEdgesThatMeet(open);
    if (met.empty())
    {
      return {};
    }
    JoinedCracks result = told(met);
    divide();
    return result;
  }

private:
  struct Pair
  {
    double distance;
    std::uint32_t lower;
    std::uint32_t upper;

    bool operator<(const Pair& other) const
    {
      return std::tie(distance, lower, upper) < std::tie(other.distance, other.lower, other.upper);
    }
    bool operator==(const Pair& other) const
    {
      return lower == other.lower && upper == other.upper;
    }
  };

  double widthAt(const Vector& place) const
  {
    return width_ > 0 ? width_ : partOfBox_ * narrowestSide(planes_, place);
  }

  Vector placeOf(std::uint32_t vertex) const { return toVector(surface_.vertices[vertex]); }
  std::int32_t regionOf(std::uint32_t triangle) const
  {
    return surface_.region.empty() ? 0 : surface_.region[triangle];
  }

  // Calls visit(corner, edge, width) for each corner of a rim and the open edges of its region that may be in reach, the width
  // of cracks there, but are not near it along rims.
  template <class Visitor>
  void forEachMeeting(const OpenRims& rims, Visitor&& visit) const
  {
    const TriangleTree triangles = movedTriangles(rims);
    const std::map<std::uint32_t, std::int32_t> regions = regionsOf(rims);
    for (const std::uint32_t corner : rims.corners())
    {
      const Vector place = placeOf(corner);
      const double width = widthAt(place);
      const std::vector<std::uint32_t> near = rims.near(corner, SameSide * width);
      const Vector reach{ width, width, width };
      triangles.forEachWithin(minus(place, reach), plus(place, reach), [&](std::uint32_t t) {
        const auto [begin, end] = rims.of(t);
        for (const OpenEdge* edge = begin; edge != end; ++edge)
        {
          if (regionOf(t) == regions.at(corner) && !isIn(near, edge->lower) &&
            !isIn(near, edge->upper))
          {
            visit(corner, *edge, width);
          }
        }
      });
    }
  }

  // Those with open edges, where their corners have moved to.
  TriangleTree movedTriangles(const OpenRims& rims) const
  {
    Surface moved;
    moved.vertices = surface_.vertices;
    moved.triangles = surface_.triangles;
    std::vector<std::uint32_t> withArea;
    for (const std::uint32_t t : rims.triangles())
    {
      for (std::uint32_t& vertex : moved.triangles[t])
      {
        vertex = goalOf(moves_, vertex);
      }
      if (axisAcross(moved.corners(t)) >= 0)
      {
        withArea.push_back(t);
      }
    }
    return { moved, std::move(withArea), execution_ };
  }

  std::map<std::uint32_t, std::int32_t> regionsOf(const OpenRims& rims) const
  {
    std::map<std::uint32_t, std::int32_t> regions;
    for (const OpenEdge& edge : rims.edges())
    {
      regions.emplace(edge.lower, regionOf(edge.triangle));
      regions.emplace(edge.upper, regionOf(edge.triangle));
    }
    return regions;
  }

  // The nearest first; a corner goes to the lowest of those that it is joined with.
  void findMoves(const OpenRims& rims)
  {
    DisjointSets sets(surface_.vertices.size());
    std::map<std::uint32_t, std::vector<std::uint32_t>> members; // of each set
    const auto membersOf = [&](std::uint32_t root) -> std::vector<std::uint32_t>& {
      std::vector<std::uint32_t>& all = members[root];
      if (all.empty())
      {
        all.push_back(root);
      }
      return all;
    };
    for (const Pair& pair : pairsOf(rims))
    {
      const std::uint32_t a = sets.find(pair.lower);
      const std::uint32_t b = sets.find(pair.upper);
      if (a == b || haveNeighbours(rims, membersOf(a), membersOf(b)))
      {
        continue;
      }
      std::vector<std::uint32_t> all = membersOf(a);
      all.insert(all.end(), membersOf(b).begin(), membersOf(b).end());
      members.erase(a);
      members.erase(b);
      sets.unite(a, b);
      membersOf(sets.find(a)) = std::move(all);
    }
    for (const auto& [root, all] : members)
    {
      const std::uint32_t lowest = *std::min_element(all.begin(), all.end());
      for (const std::uint32_t vertex : all)
      {
        if (vertex != lowest)
        {
          moves_.emplace(vertex, lowest);
        }
      }
    }
  }

  std::vector<Pair> pairsOf(const OpenRims& rims) const
  {
    std::vector<Pair> pairs;
    forEachMeeting(rims, [&](std::uint32_t corner, const OpenEdge& edge, double width) {
      for (const std::uint32_t end : { edge.lower, edge.upper })
      {
        const Vector way = minus(surface_.vertices[end], surface_.vertices[corner]);
        if (dot(way, way) <= width * width && !rims.areOfOneTriangle(corner, end))
        {
          pairs.push_back({ dot(way, way), std::min(corner, end), std::max(corner, end) });
        }
      }
    });
    std::sort(pairs.begin(), pairs.end());
    pairs.erase(std::unique(pairs.begin(), pairs.end()), pairs.end());
    return pairs;
  }

  // Whether two of them are on one side of a crack.
  bool haveNeighbours(const OpenRims& rims, const std::vector<std::uint32_t>& some,
    const std::vector<std::uint32_t>& others) const
  {
    return std::any_of(some.begin(), some.end(), [&](std::uint32_t corner) {
      const std::vector<std::uint32_t> near =
        rims.near(corner, SameSide * widthAt(placeOf(corner)));
      return std::any_of(others.begin(), others.end(), [&](std::uint32_t other) {
        return isIn(near, other) || rims.areOfOneTriangle(corner, other);
      });
    });
  }

  // Those that are open still where corners have moved.
  std::vector<OpenEdge> movedEdges(const std::vector<OpenEdge>& open) const
  {
    std::map<std::array<std::uint32_t, 2>, std::pair<std::uint32_t, bool>> edges;
    for (const OpenEdge& edge : open)
    {
      const std::uint32_t a = goalOf(moves_, edge.lower);
      const std::uint32_t b = goalOf(moves_, edge.upper);
      if (a != b)
      {
        const auto [known, isNew] = edges.emplace(
          std::array{ std::min(a, b), std::max(a, b) }, std::pair{ edge.triangle, true });
        known->second.second = isNew || !known->second.second;
      }
    }
    std::vector<OpenEdge> result;
    for (const auto& [ends, use] : edges)
    {
      if (use.second)
      {
        result.push_back({ use.first, ends[0], ends[1] });
      }
    }
    return result;
  }

  // Open edges go through the corners near them.
  void findPoints(const OpenRims& rims, const OpenRims& given)
  {
    std::map<std::uint32_t, std::vector<std::uint32_t>> joined; // corners, by where they have gone
    for (const auto& [from, to] : moves_)
    {
      joined[to].push_back(from);
    }
    // Straight along the rim from one to the other: they are corners of a face that is divided otherwise than the one beside it.
    const auto areAlongRim = [&](std::uint32_t one, std::uint32_t end, double width) {
      const double length = norm(minus(surface_.vertices[end], surface_.vertices[one]));
      return length > SameSide * width && isIn(given.near(one, length * (1 + Straight)), end);
    };
    const auto isOfStrip = [&](std::uint32_t corner, const OpenEdge& edge, double width) {
      std::vector<std::uint32_t> all =
        joined.count(corner) > 0 ? joined.at(corner) : std::vector<std::uint32_t>();
      all.push_back(corner);
      const auto& ends = surface_.triangles[edge.triangle];
      return std::any_of(all.begin(), all.end(), [&](std::uint32_t one) {
        return std::any_of(ends.begin(), ends.end(), [&](std::uint32_t end) {
          return given.areOfOneTriangle(one, end) && !areAlongRim(one, end, width);
        });
      });
    };
    forEachMeeting(rims, [&](std::uint32_t corner, const OpenEdge& edge, double width) {
      const Vector from = placeOf(edge.lower);
      const Vector way = minus(placeOf(edge.upper), from);
      const double along = dot(way, minus(placeOf(corner), from)) / std::max(dot(way, way), 1.);
      if (along > 0 && along < 1 && distanceOf(corner, edge.lower, edge.upper) <= width &&
        !isOfStrip(corner, edge, width))
      {
        onEdge_[{ edge.lower, edge.upper }].emplace(along, corner);
      }
    });
  }

  // Of a corner from the line through two others.
  double distanceOf(std::uint32_t corner, std::uint32_t a, std::uint32_t b) const
  {
    const Vector way = minus(placeOf(b), placeOf(a));
    const Vector to = minus(placeOf(corner), placeOf(a));
    return norm(minus(to, scaled(way, dot(way, to) / std::max(dot(way, way), 1.))));
  }

  // The parts of an open edge: its corners in turn.
  std::vector<std::uint32_t> chainOf(const OpenEdge& edge) const
  {
    const std::uint32_t from = goalOf(moves_, edge.lower);
    const std::uint32_t to = goalOf(moves_, edge.upper);
    std::vector<std::uint32_t> chain{ from };
    if (from != to)
    {
      const std::vector<std::uint32_t> between = pointsOn(onEdge_, from, to);
      chain.insert(chain.end(), between.begin(), between.end());
      chain.push_back(to);
    }
    return chain;
  }

  // A corner alone that is near an edge leaves it as it is: only where edges run along each other they are joined. Returns the
  // parts of edges that do.
  std::vector<Part> keepThoseOfEdgesThatMeet(const std::vector<OpenEdge>& open)
  {
    std::map<Part, int> uses;
    const auto forEachPart = [&](const OpenEdge& edge, auto&& visit) {
      const std::vector<std::uint32_t> chain = chainOf(edge);
      for (std::size_t i = 0; i + 1 < chain.size(); ++i)
      {
        visit(Part{ std::min(chain[i], chain[i + 1]), std::max(chain[i], chain[i + 1]) });
      }
    };
    for (const OpenEdge& edge : open)
    {
      forEachPart(edge, [&](const auto& part) { ++uses[part]; });
    }
    std::set<std::uint32_t> kept;
    std::vector<Part> met;
    for (const auto& [part, count] : uses)
    {
      if (count > 1)
      {
        kept.insert(part.begin(), part.end());
        met.push_back(part);
      }
    }
    keepEndsOfDividedEdges(kept);
    for (auto move = moves_.begin(); move != moves_.end();)
    {
      move = kept.count(move->second) > 0 ? std::next(move) : moves_.erase(move);
    }
    for (auto edge = onEdge_.begin(); edge != onEdge_.end();)
    {
      for (auto point = edge->second.begin(); point != edge->second.end();)
      {
        point = kept.count(point->second) > 0 ? std::next(point) : edge->second.erase(point);
      }
      edge = edge->second.empty() ? onEdge_.erase(edge) : std::next(edge);
    }
    return met;
  }

  // Edges are divided as they are where their ends have moved.
  void keepEndsOfDividedEdges(std::set<std::uint32_t>& kept) const
  {
    std::size_t before = 0;
    while (before != kept.size())
    {
      before = kept.size();
      for (const auto& [ends, points] : onEdge_)
      {
        if (std::any_of(points.begin(), points.end(),
              [&](const auto& point) { return kept.count(point.second) > 0; }))
        {
          kept.insert(ends.begin(), ends.end());
        }
      }
    }
  }

  // How far each corner is at most from what it is joined with.
  std::map<std::uint32_t, double> widths() const
  {
    std::map<std::uint32_t, double> widths;
    const auto tell = [&](double distance, std::uint32_t corner) {
      double& widest = widths[corner];
      widest = std::max(widest, distance);
    };
    for (const auto& [from, to] : moves_)
    {
      tell(norm(minus(placeOf(from), placeOf(to))), to);
    }
    for (const auto& [ends, points] : onEdge_)
    {
      for (const auto& [along, corner] : points)
      {
        tell(distanceOf(corner, ends[0], ends[1]), corner);
      }
    }
    return widths;
  }

  JoinedCracks told(const std::vector<Part>& met) const
  {
    JoinedCracks result;
    const std::map<std::uint32_t, double> widths = this->widths();
    const auto widthOf = [&](std::uint32_t corner) {
      const auto found = widths.find(corner);
      return found != widths.end() ? found->second : 0;
    };
    for (const Part& part : met)
    {
      result.joined.push_back(
        { { placeOf(part[0]), placeOf(part[1]) }, std::max(widthOf(part[0]), widthOf(part[1])) });
    }
    return result;
  }

  void divide()
  {
    std::vector<std::array<std::uint32_t, 3>> parts;
    const std::size_t count = surface_.triangles.size();
    for (std::size_t t = 0; t < count; ++t)
    {
      std::array<std::uint32_t, 3> c = surface_.triangles[t];
      for (std::uint32_t& vertex : c)
      {
        vertex = goalOf(moves_, vertex);
      }
      parts.clear();
      divideAtEdges(c,
        { pointsOn(onEdge_, c[0], c[1]), pointsOn(onEdge_, c[1], c[2]),
          pointsOn(onEdge_, c[2], c[0]) },
        parts);
      surface_.triangles[t] = parts.front();
      for (std::size_t i = 1; i < parts.size(); ++i)
      {
        surface_.triangles.push_back(parts[i]);
        surface_.boundary.push_back(surface_.boundary[t]);
        surface_.given.push_back(surface_.given[t]);
        if (!surface_.region.empty())
        {
          surface_.region.push_back(surface_.region[t]);
        }
      }
    }
  }

  Surface& surface_;
  const Meshlines& planes_;
  double width_; // levels; 0: by the boxes
  double partOfBox_;
  Execution& execution_;
  CornerMoves moves_;
  EdgePoints onEdge_; // of open edges whose ends have moved
};

}

JoinedCracks joinCracks(
  Surface& surface, const Meshlines& planes, const CrackSpec& spec, int depth, Execution& execution)
{
  return CrackJoiner(surface, planes, spec, depth, execution).join();
}

}
