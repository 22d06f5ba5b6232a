// SPDX-License-Identifier: BSD-3-Clause
#include "Repair/Cracks.h"

#include "Base/DisjointSets.h"
#include "Repair/EdgePoints.h"
#include "Repair/TriangleTree.h"
#include "Surface/SurfaceEdges.h"

#include <algorithm>
#include <cmath>
#include <map>

namespace cartesian
{

namespace
{

// What is nearer than this along a rim, by the width of cracks there, is the same side of a crack.
constexpr double SameSide = 4;

// The open edges of a surface: an odd number of triangles use them.
class OpenRims
{
public:
  struct Edge
  {
    std::uint32_t triangle;
    std::uint32_t lower;
    std::uint32_t upper;

    bool operator<(const Edge& other) const
    {
      return triangle != other.triangle ? triangle < other.triangle
        : lower != other.lower          ? lower < other.lower
                                        : upper < other.upper;
    }
  };

  OpenRims(const Surface& surface, Execution& execution)
    : surface_(surface)
  {
    SurfaceEdges(surface, execution)
      .forEach([&](std::uint32_t lower, const EdgeUse* begin, const EdgeUse* end) {
        if ((end - begin) % 2 == 1)
        {
          edges_.push_back({ begin->triangle(), lower, begin->upper });
        }
      });
    std::sort(edges_.begin(), edges_.end());
    for (const Edge& edge : edges_)
    {
      ends_.emplace_back(edge.lower, edge.upper);
      ends_.emplace_back(edge.upper, edge.lower);
    }
    std::sort(ends_.begin(), ends_.end());
  }

  const std::vector<Edge>& edges() const { return edges_; }

  // Those of a triangle.
  std::pair<const Edge*, const Edge*> of(std::uint32_t triangle) const
  {
    const auto range = std::equal_range(edges_.begin(), edges_.end(), Edge{ triangle, 0, 0 },
      [](const Edge& a, const Edge& b) { return a.triangle < b.triangle; });
    return { edges_.data() + (range.first - edges_.begin()),
      edges_.data() + (range.second - edges_.begin()) };
  }

  // Each corner of a rim, in order.
  std::vector<std::uint32_t> corners() const
  {
    std::vector<std::uint32_t> all;
    for (const auto& [vertex, other] : ends_)
    {
      if (all.empty() || all.back() != vertex)
      {
        all.push_back(vertex);
      }
    }
    return all;
  }

  // The corners at most `length` along rims from one, which is the first; in order then.
  std::vector<std::uint32_t> near(std::uint32_t corner, double length) const
  {
    std::map<std::uint32_t, double> reached{ { corner, 0 } };
    std::vector<std::uint32_t> next{ corner };
    while (!next.empty())
    {
      const std::uint32_t from = next.back();
      next.pop_back();
      for (auto end = std::lower_bound(ends_.begin(), ends_.end(), std::pair{ from, 0U });
           end != ends_.end() && end->first == from; ++end)
      {
        const double way =
          reached[from] + norm(minus(surface_.vertices[end->second], surface_.vertices[from]));
        const auto [known, isNew] = reached.emplace(end->second, way);
        if (way <= length && (isNew || way < known->second))
        {
          known->second = way;
          next.push_back(end->second);
        }
        else if (isNew)
        {
          reached.erase(known);
        }
      }
    }
    std::vector<std::uint32_t> all;
    all.reserve(reached.size());
    for (const auto& [vertex, way] : reached)
    {
      all.push_back(vertex);
    }
    return all;
  }

private:
  const Surface& surface_;
  std::vector<Edge> edges_;                                   // by triangle
  std::vector<std::pair<std::uint32_t, std::uint32_t>> ends_; // of edges, from either
};

bool isIn(const std::vector<std::uint32_t>& sorted, std::uint32_t vertex)
{
  return std::binary_search(sorted.begin(), sorted.end(), vertex);
}

// The triangles with open edges, by place.
class RimTriangles
{
public:
  RimTriangles(const Surface& surface, const OpenRims& rims, Execution& execution)
    : numbers_(numbersOf(rims))
    , tree_(only(surface, numbers_), execution)
  {
  }

  template <class Visitor>
  void forEachNear(const Vector& place, double distance, Visitor&& visit) const
  {
    const Vector reach{ distance, distance, distance };
    tree_.forEachWithin(
      minus(place, reach), plus(place, reach), [&](std::uint32_t t) { visit(numbers_[t]); });
  }

private:
  static std::vector<std::uint32_t> numbersOf(const OpenRims& rims)
  {
    std::vector<std::uint32_t> numbers;
    for (const OpenRims::Edge& edge : rims.edges())
    {
      if (numbers.empty() || numbers.back() != edge.triangle)
      {
        numbers.push_back(edge.triangle);
      }
    }
    return numbers;
  }

  static Surface only(const Surface& surface, const std::vector<std::uint32_t>& numbers)
  {
    Surface result;
    result.vertices = surface.vertices;
    for (const std::uint32_t t : numbers)
    {
      result.triangles.push_back(surface.triangles[t]);
    }
    return result;
  }

  std::vector<std::uint32_t> numbers_; // of the triangles of the tree
  TriangleTree tree_;
};

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
    const std::size_t before = OpenRims(surface_, execution_).edges().size();
    if (before == 0)
    {
      return {};
    }
    joinCorners();
    divideEdges();
    const std::size_t after = OpenRims(surface_, execution_).edges().size();
    result_.edges = before > after ? before - after : 0;
    return result_;
  }

private:
  struct Pair
  {
    double distance;
    std::uint32_t lower;
    std::uint32_t upper;

    bool operator<(const Pair& other) const
    {
      return distance != other.distance ? distance < other.distance
        : lower != other.lower          ? lower < other.lower
                                        : upper < other.upper;
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
    const RimTriangles triangles(surface_, rims, execution_);
    const std::map<std::uint32_t, std::int32_t> regions = regionsOf(rims);
    for (const std::uint32_t corner : rims.corners())
    {
      const Vector place = placeOf(corner);
      const double width = widthAt(place);
      const std::vector<std::uint32_t> near = rims.near(corner, SameSide * width);
      triangles.forEachNear(place, width, [&](std::uint32_t t) {
        const auto [begin, end] = rims.of(t);
        for (const OpenRims::Edge* edge = begin; edge != end; ++edge)
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

  std::map<std::uint32_t, std::int32_t> regionsOf(const OpenRims& rims) const
  {
    std::map<std::uint32_t, std::int32_t> regions;
    for (const OpenRims::Edge& edge : rims.edges())
    {
      regions.emplace(edge.lower, regionOf(edge.triangle));
      regions.emplace(edge.upper, regionOf(edge.triangle));
    }
    return regions;
  }

  // The nearest first; a corner goes to the lowest of those that it is joined with.
  void joinCorners()
  {
    const OpenRims rims(surface_, execution_);
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
      tell(std::sqrt(pair.distance), placeOf(pair.upper));
    }
    std::map<std::uint32_t, std::uint32_t> moved;
    for (const auto& [root, all] : members)
    {
      const std::uint32_t lowest = *std::min_element(all.begin(), all.end());
      for (const std::uint32_t vertex : all)
      {
        if (vertex != lowest)
        {
          moved.emplace(vertex, lowest);
        }
      }
    }
    renumber(moved);
  }

  std::vector<Pair> pairsOf(const OpenRims& rims) const
  {
    std::vector<Pair> pairs;
    forEachMeeting(rims, [&](std::uint32_t corner, const OpenRims::Edge& edge, double width) {
      for (const std::uint32_t end : { edge.lower, edge.upper })
      {
        const Vector way = minus(surface_.vertices[end], surface_.vertices[corner]);
        if (dot(way, way) <= width * width)
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
      return std::any_of(
        others.begin(), others.end(), [&](std::uint32_t other) { return isIn(near, other); });
    });
  }

  void renumber(const std::map<std::uint32_t, std::uint32_t>& moved)
  {
    if (moved.empty())
    {
      return;
    }
    for (auto& triangle : surface_.triangles)
    {
      for (std::uint32_t& vertex : triangle)
      {
        const auto found = moved.find(vertex);
        vertex = found != moved.end() ? found->second : vertex;
      }
    }
  }

  // Leads open edges through the corners near them.
  void divideEdges()
  {
    EdgePoints onEdge;
    const OpenRims rims(surface_, execution_);
    forEachMeeting(rims, [&](std::uint32_t corner, const OpenRims::Edge& edge, double width) {
      const Vector from = placeOf(edge.lower);
      const Vector way = minus(placeOf(edge.upper), from);
      const Vector to = minus(placeOf(corner), from);
      const double along = dot(way, to) / std::max(dot(way, way), 1.);
      const double distance = norm(minus(to, scaled(way, along)));
      if (along > 0 && along < 1 && distance <= width)
      {
        onEdge[{ edge.lower, edge.upper }].emplace(along, corner);
        tell(distance, placeOf(corner));
      }
    });
    if (!onEdge.empty())
    {
      divide(onEdge);
    }
  }

  void divide(const EdgePoints& onEdge)
  {
    std::vector<std::array<std::uint32_t, 3>> parts;
    const std::size_t count = surface_.triangles.size();
    for (std::size_t t = 0; t < count; ++t)
    {
      const std::array<std::uint32_t, 3> c = surface_.triangles[t];
      parts.clear();
      divideAtEdges(c,
        { pointsOn(onEdge, c[0], c[1]), pointsOn(onEdge, c[1], c[2]),
          pointsOn(onEdge, c[2], c[0]) },
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

  void tell(double distance, const Vector& place)
  {
    if (distance > result_.width)
    {
      result_.width = distance;
      result_.place = place;
    }
  }

  Surface& surface_;
  const Meshlines& planes_;
  double width_; // levels; 0: by the boxes
  double partOfBox_;
  Execution& execution_;
  JoinedCracks result_;
};

}

JoinedCracks joinCracks(
  Surface& surface, const Meshlines& planes, const CrackSpec& spec, int depth, Execution& execution)
{
  return CrackJoiner(surface, planes, spec, depth, execution).join();
}

}
