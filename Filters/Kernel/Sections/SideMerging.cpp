// SPDX-License-Identifier: BSD-3-Clause
#include "Sections/SideMerging.h"

#include "Lattice/Vector.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <set>

namespace cartesian
{

namespace
{

constexpr int MostRounds = 16;

// OpenFOAM's: the size of a face, for its skewness, is at least this part of the way between its cells.
constexpr double LeastSize = 0.2;
constexpr double LeastSizeOnBoundary = 0.4; // and its wall

struct PolygonShape
{
  double area = 0;
  Vector centre{};
  bool isForward = true; // counter-clockwise around the axis
};

// An edge between two polygons.
struct Seam
{
  std::array<std::uint32_t, 2> ends;
  std::array<std::size_t, 2> polygons;
};

class SideMerger
{
public:
  SideMerger(const std::vector<double>& points,
    const std::function<bool(std::uint32_t, std::uint32_t)>& areOne,
    const std::function<long long(std::size_t)>& boundaryOf, SideFaces& side)
    : points_(points)
    , areOne_(areOne)
    , boundaryOf_(boundaryOf)
    , side_(side)
  {
  }

  void merge()
  {
    dropStraight();
    for (int round = 0; round < MostRounds && mergeOnce(); ++round)
    {
      dropStraight();
    }
  }

private:
  Vector at(std::uint32_t point) const
  {
    const double* p = points_.data() + 3 * std::size_t(point);
    return { p[0], p[1], p[2] };
  }

  // Points of two edges that are one, unless less than a triangle were left of a polygon.
  void dropStraight()
  {
    std::set<std::uint32_t> straight = straightPoints();
    for (std::size_t p = 0; p < side_.count(); ++p)
    {
      const std::vector<BorderEdge> edges = edgesOf(p);
      const auto left = std::count_if(edges.begin(), edges.end(),
        [&](const BorderEdge& edge) { return straight.count(edge.from) == 0; });
      for (std::size_t i = 0; left < 3 && i < edges.size(); ++i)
      {
        straight.erase(edges[i].from);
      }
    }
    SideFaces left;
    for (std::size_t p = 0; p < side_.count(); ++p)
    {
      std::vector<BorderEdge> border = edgesOf(p);
      border.erase(std::remove_if(border.begin(), border.end(),
                     [&](const BorderEdge& edge) { return straight.count(edge.from) > 0; }),
        border.end());
      addPolygon(border, side_.cellOf[p], left);
    }
    side_ = std::move(left);
  }

  std::set<std::uint32_t> straightPoints() const
  {
    std::map<std::uint32_t, std::set<std::uint32_t>> next; // along edges
    std::map<std::uint32_t, std::set<long long>> boundaries;
    for (std::size_t p = 0; p < side_.count(); ++p)
    {
      for (std::size_t i = 0; i < side_.size(p); ++i)
      {
        const BorderEdge edge = side_.edge(p, i);
        for (const auto& [end, other] :
          { std::pair(edge.from, edge.to), std::pair(edge.to, edge.from) })
        {
          next[end].insert(other);
          boundaries[end].insert(boundaryOf_(edge.beside));
        }
      }
    }
    std::set<std::uint32_t> straight;
    for (const auto& [point, ends] : next)
    {
      if (ends.size() == 2 && boundaries.at(point).size() == 1 &&
        areOneEdge(minus(at(*ends.begin()), at(point)), minus(at(*ends.rbegin()), at(point))))
      {
        straight.insert(point);
      }
    }
    return straight;
  }

  // From the point between them.
  static bool areOneEdge(const Vector& a, const Vector& b)
  {
    const double shorter = std::min(norm(a), norm(b));
    const double longer = std::max(norm(a), norm(b));
    const double aside = norm(cross(a, b)) / longer; // of the point, from the longer one
    const bool isShort = shorter < SideMerging::Short * longer;
    return dot(a, b) < 0 &&
      aside <= (isShort ? std::min(SideMerging::Bent * shorter, SideMerging::Aside * longer)
                        : SideMerging::Straight * shorter);
  }

  // Whether any were united.
  bool mergeOnce()
  {
    shapes_.clear();
    for (std::size_t p = 0; p < side_.count(); ++p)
    {
      shapes_.push_back(shapeOf(edgesOf(p)));
    }
    findSeams();
    std::map<std::size_t, std::vector<BorderEdge>> united; // by one of the two
    std::vector<std::uint8_t> isTaken(side_.count());
    std::vector<std::uint8_t> isGone(side_.count());
    const auto uniteOne = [&](std::size_t polygon) {
      Union best = bestUnionOf(polygon, isTaken);
      if (best.border.empty())
      {
        return false;
      }
      isTaken[polygon] = isTaken[best.with] = isGone[polygon] = 1;
      united.emplace(best.with, std::move(best.border));
      return true;
    };
    for (const auto& [first, second] : refused())
    {
      if (isTaken[first] == 0 && isTaken[second] == 0 && !uniteOne(first))
      {
        uniteOne(second);
      }
    }
    SideFaces left;
    for (std::size_t p = 0; p < side_.count(); ++p)
    {
      if (isGone[p] == 0)
      {
        const auto border = united.find(p);
        addPolygon(border != united.end() ? border->second : edgesOf(p), side_.cellOf[p], left);
      }
    }
    side_ = std::move(left);
    return !united.empty();
  }

  // Of a polygon and a neighbour; no border: none.
  struct Union
  {
    std::size_t with = 0;
    std::vector<BorderEdge> border = {};
  };

  // What leaves the fewest refused edges, if it leaves fewer than there are.
  Union bestUnionOf(std::size_t polygon, const std::vector<std::uint8_t>& isTaken) const
  {
    Union best;
    std::size_t fewest = 0;
    for (const std::size_t other : neighboursOf(polygon))
    {
      std::vector<BorderEdge> border =
        isTaken[other] == 0 ? unitedBorder(polygon, other) : std::vector<BorderEdge>();
      const std::size_t refusedNow = border.empty() ? 0 : refusedOf(border, { polygon, other });
      if (!border.empty() &&
        refusedNow < (best.border.empty() ? refusedOf(polygon, other) : fewest))
      {
        best = { other, std::move(border) };
        fewest = refusedNow;
      }
    }
    return best;
  }

  std::vector<BorderEdge> unitedBorder(std::size_t small, std::size_t large) const
  {
    std::vector<BorderEdge> edges = edgesOf(large);
    const std::vector<BorderEdge> others = edgesOf(small);
    edges.insert(edges.end(), others.begin(), others.end());
    return borderOf(edges);
  }

  // How many edges of a polygon made of these two are refused.
  std::size_t refusedOf(
    const std::vector<BorderEdge>& border, const std::array<std::size_t, 2>& of) const
  {
    const PolygonShape shape = shapeOf(border);
    return static_cast<std::size_t>(
      std::count_if(border.begin(), border.end(), [&](const BorderEdge& edge) {
        const auto seam =
          seamAt_.find({ std::min(edge.from, edge.to), std::max(edge.from, edge.to) });
        if (seam == seamAt_.end())
        {
          return isRefusedOnBoundary(edge, shape);
        }
        const auto& [p, q] = seams_[seam->second].polygons;
        const std::size_t beyond = p == of[0] || p == of[1] ? q : p;
        return isRefused({ edge.to, edge.from }, shape, shapes_[beyond]);
      }));
  }

  // ... of the two as they are.
  std::size_t refusedOf(std::size_t polygon, std::size_t other) const
  {
    std::set<std::size_t> seams(seamsOf_[polygon].begin(), seamsOf_[polygon].end());
    seams.insert(seamsOf_[other].begin(), seamsOf_[other].end());
    auto count = std::count_if(
      seams.begin(), seams.end(), [&](std::size_t s) { return isRefused(seams_[s]); });
    for (const std::size_t p : { polygon, other })
    {
      const std::vector<BorderEdge> edges = edgesOf(p);
      count += std::count_if(edges.begin(), edges.end(), [&](const BorderEdge& edge) {
        return boundaryOf_(edge.beside) != InnerEdge && isRefusedOnBoundary(edge, shapes_[p]);
      });
    }
    return static_cast<std::size_t>(count);
  }

  // Whether the centre is on the inner side of an edge of its polygon.
  bool sees(const PolygonShape& shape, std::uint32_t from, std::uint32_t to) const
  {
    const Vector part = cross(minus(at(from), shape.centre), minus(at(to), shape.centre));
    return (part[0] + part[1] + part[2] > 0) == shape.isForward;
  }

  PolygonShape shapeOf(const std::vector<BorderEdge>& border) const
  {
    const Vector base = at(border.front().from);
    Vector sum{};
    Vector moment{};
    for (const BorderEdge& edge : border)
    {
      const Vector a = minus(at(edge.from), base);
      const Vector b = minus(at(edge.to), base);
      const Vector part = cross(a, b);
      const double signedArea = part[0] + part[1] + part[2]; // the side is across an axis
      sum = plus(sum, part);
      moment = plus(moment, scaled(plus(a, b), signedArea / 3));
    }
    const double twice = sum[0] + sum[1] + sum[2];
    return { std::abs(twice) / 2, twice == 0 ? base : plus(base, scaled(moment, 1 / twice)),
      twice > 0 };
  }

  void findSeams()
  {
    std::map<std::array<std::uint32_t, 2>, std::size_t> first;
    seams_.clear();
    seamAt_.clear();
    for (std::size_t p = 0; p < side_.count(); ++p)
    {
      for (std::size_t i = 0; i < side_.size(p); ++i)
      {
        const BorderEdge edge = side_.edge(p, i);
        if (boundaryOf_(edge.beside) != InnerEdge)
        {
          continue;
        }
        const std::array ends{ std::min(edge.from, edge.to), std::max(edge.from, edge.to) };
        const auto [known, isNew] = first.emplace(ends, p);
        if (!isNew)
        {
          seamAt_[ends] = seams_.size();
          seams_.push_back({ { edge.from, edge.to }, { known->second, p } });
        }
      }
    }
    seamsOf_.assign(side_.count(), {});
    for (std::size_t s = 0; s < seams_.size(); ++s)
    {
      for (const std::size_t p : seams_[s].polygons)
      {
        seamsOf_[p].push_back(s);
      }
    }
  }

  // The polygons of each edge that is skew or not orthogonal: the smaller, and the other. On a boundary there is one.
  std::vector<std::array<std::size_t, 2>> refused() const
  {
    std::vector<std::array<std::size_t, 2>> all;
    for (const Seam& seam : seams_)
    {
      if (isRefused(seam))
      {
        const auto [p, q] = seam.polygons;
        const bool isFirstSmaller = shapes_[p].area <= shapes_[q].area;
        all.push_back({ isFirstSmaller ? p : q, isFirstSmaller ? q : p });
      }
    }
    for (std::size_t p = 0; p < side_.count(); ++p)
    {
      for (std::size_t i = 0; i < side_.size(p); ++i)
      {
        const BorderEdge edge = side_.edge(p, i);
        if (boundaryOf_(edge.beside) != InnerEdge && isRefusedOnBoundary(edge, shapes_[p]))
        {
          all.push_back({ p, p });
        }
      }
    }
    return all;
  }

  bool isRefusedOnBoundary(const BorderEdge& edge, const PolygonShape& shape) const
  {
    const Vector along = minus(at(edge.to), at(edge.from));
    const double length = norm(along);
    const Vector way = minus(scaled(plus(at(edge.from), at(edge.to)), 0.5), shape.centre);
    const double aside = length == 0 ? 0 : std::abs(dot(way, along)) / length;
    const double through = std::sqrt(std::max(0., dot(way, way) - aside * aside));
    return !sees(shape, edge.from, edge.to) ||
      aside > SideMerging::MostSkewness * std::max(LeastSizeOnBoundary * through, length / 2);
  }

  bool isRefused(const Seam& seam) const
  {
    return isRefused(seam.ends, shapes_[seam.polygons[0]], shapes_[seam.polygons[1]]);
  }

  // `ends`: as the second polygon has them.
  bool isRefused(const std::array<std::uint32_t, 2>& ends, const PolygonShape& first,
    const PolygonShape& second) const
  {
    const Vector a = at(ends[0]);
    const Vector b = at(ends[1]);
    const Vector along = minus(b, a);
    const Vector way = minus(second.centre, first.centre);
    const double length = norm(along);
    if (length == 0 || norm(way) == 0 || !sees(second, ends[0], ends[1]) ||
      !sees(first, ends[1], ends[0]))
    {
      return true;
    }
    const Vector unitAlong = scaled(along, 1 / length);
    const double aside = dot(way, unitAlong);
    const double through = std::sqrt(std::max(0., dot(way, way) - aside * aside));
    if (through <= norm(way) * std::cos(radians(SideMerging::MostNonOrthogonality)))
    {
      return true;
    }
    // Where the way passes the edge's line, from its middle.
    const Vector toMiddle = minus(scaled(plus(a, b), 0.5), first.centre);
    const double alongMiddle = dot(toMiddle, unitAlong);
    const double depth =
      std::sqrt(std::max(0., dot(toMiddle, toMiddle) - alongMiddle * alongMiddle));
    const double skew = std::abs(alongMiddle - aside * depth / through);
    return skew > SideMerging::MostSkewness * std::max(LeastSize * norm(way), length / 2);
  }

  // Those along whose edges the longest part of its border is first.
  std::vector<std::size_t> neighboursOf(std::size_t polygon) const
  {
    std::map<std::size_t, double> shared;
    for (const std::size_t s : seamsOf_[polygon])
    {
      const Seam& seam = seams_[s];
      const std::size_t other = seam.polygons[seam.polygons[0] == polygon ? 1 : 0];
      if (areOne_(side_.cellOf[polygon], side_.cellOf[other]))
      {
        shared[other] += norm(minus(at(seam.ends[0]), at(seam.ends[1])));
      }
    }
    std::vector<std::size_t> all;
    all.reserve(shared.size());
    for (const auto& [other, length] : shared)
    {
      all.push_back(other);
    }
    std::stable_sort(all.begin(), all.end(),
      [&](std::size_t a, std::size_t b) { return shared.at(a) > shared.at(b); });
    return all;
  }

  std::vector<BorderEdge> edgesOf(std::size_t polygon) const
  {
    std::vector<BorderEdge> edges;
    edges.reserve(side_.size(polygon));
    for (std::size_t i = 0; i < side_.size(polygon); ++i)
    {
      edges.push_back(side_.edge(polygon, i));
    }
    return edges;
  }

  const std::vector<double>& points_;
  const std::function<bool(std::uint32_t, std::uint32_t)>& areOne_;
  const std::function<long long(std::size_t)>& boundaryOf_;
  SideFaces& side_;
  std::vector<PolygonShape> shapes_;
  std::map<std::array<std::uint32_t, 2>, std::size_t> seamAt_; // by its ends, ascending
  std::vector<Seam> seams_;
  std::vector<std::vector<std::size_t>> seamsOf_; // of each polygon
};

}

void mergeSkew(const std::vector<double>& points,
  const std::function<bool(std::uint32_t, std::uint32_t)>& areOne,
  const std::function<long long(std::size_t)>& boundaryOf, SideFaces& side)
{
  SideMerger(points, areOne, boundaryOf, side).merge();
}

}
