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

struct PolygonShape
{
  double area = 0;
  Vector centre{};
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

  // Points of two edges that are one.
  void dropStraight()
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
    const auto isStraight = [&](std::uint32_t point) {
      const std::set<std::uint32_t>& ends = next.at(point);
      if (ends.size() != 2 || boundaries.at(point).size() != 1)
      {
        return false;
      }
      const Vector a = minus(at(*ends.begin()), at(point));
      const Vector b = minus(at(*ends.rbegin()), at(point));
      return dot(a, b) < 0 && norm(cross(a, b)) <= SideMerging::Straight * norm(a) * norm(b);
    };
    SideFaces left;
    for (std::size_t p = 0; p < side_.count(); ++p)
    {
      std::vector<BorderEdge> border;
      for (const BorderEdge& edge : edgesOf(p))
      {
        if (!isStraight(edge.from))
        {
          border.push_back(edge);
        }
      }
      addPolygon(border, side_.cellOf[p], left);
    }
    side_ = std::move(left);
  }

  // Whether any were united.
  bool mergeOnce()
  {
    shapes_.clear();
    for (std::size_t p = 0; p < side_.count(); ++p)
    {
      shapes_.push_back(shapeOf(p));
    }
    findSeams();
    std::map<std::size_t, std::size_t> into; // of polygons
    std::vector<std::uint8_t> isTaken(side_.count());
    for (const Seam& seam : seams_)
    {
      if (!isRefused(seam))
      {
        continue;
      }
      const auto [p, q] = seam.polygons;
      const std::size_t small = shapes_[p].area <= shapes_[q].area ? p : q;
      const std::size_t large = neighbourOf(small);
      if (isTaken[small] == 0 && isTaken[large] == 0 && large != small)
      {
        isTaken[small] = isTaken[large] = 1;
        into.emplace(large, small);
      }
    }
    return unite(into);
  }

  PolygonShape shapeOf(std::size_t polygon) const
  {
    const Vector base = at(side_.edge(polygon, 0).from);
    Vector sum{};
    Vector moment{};
    for (std::size_t i = 0; i < side_.size(polygon); ++i)
    {
      const BorderEdge edge = side_.edge(polygon, i);
      const Vector a = minus(at(edge.from), base);
      const Vector b = minus(at(edge.to), base);
      const Vector part = cross(a, b);
      const double signedArea = part[0] + part[1] + part[2]; // the side is across an axis
      sum = plus(sum, part);
      moment = plus(moment, scaled(plus(a, b), signedArea / 3));
    }
    const double twice = sum[0] + sum[1] + sum[2];
    return { std::abs(twice) / 2, twice == 0 ? base : plus(base, scaled(moment, 1 / twice)) };
  }

  void findSeams()
  {
    std::map<std::array<std::uint32_t, 2>, std::size_t> first;
    seams_.clear();
    for (std::size_t p = 0; p < side_.count(); ++p)
    {
      for (std::size_t i = 0; i < side_.size(p); ++i)
      {
        const BorderEdge edge = side_.edge(p, i);
        if (boundaryOf_(edge.beside) != InnerEdge)
        {
          continue;
        }
        const auto [known, isNew] = first.emplace(
          std::array{ std::min(edge.from, edge.to), std::max(edge.from, edge.to) }, p);
        if (!isNew)
        {
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

  bool isRefused(const Seam& seam) const
  {
    const Vector a = at(seam.ends[0]);
    const Vector b = at(seam.ends[1]);
    const Vector along = minus(b, a);
    const Vector way = minus(shapes_[seam.polygons[1]].centre, shapes_[seam.polygons[0]].centre);
    const double length = norm(along);
    if (length == 0 || norm(way) == 0)
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
    const Vector toMiddle = minus(scaled(plus(a, b), 0.5), shapes_[seam.polygons[0]].centre);
    const double alongMiddle = dot(toMiddle, unitAlong);
    const double depth =
      std::sqrt(std::max(0., dot(toMiddle, toMiddle) - alongMiddle * alongMiddle));
    const double skew = std::abs(alongMiddle - aside * depth / through);
    return skew > SideMerging::MostSkewness * std::max(LeastSize * norm(way), length / 2);
  }

  // Along whose edges the longest part of its border is.
  std::size_t neighbourOf(std::size_t polygon) const
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
    std::size_t best = polygon;
    double most = 0;
    for (const auto& [other, length] : shared)
    {
      best = length > most ? other : best;
      most = std::max(most, length);
    }
    return best;
  }

  bool unite(const std::map<std::size_t, std::size_t>& into)
  {
    SideFaces united;
    std::vector<std::uint8_t> isGone(side_.count());
    bool any = false;
    std::map<std::size_t, std::vector<BorderEdge>> borders;
    for (const auto& [large, small] : into)
    {
      std::vector<BorderEdge> edges = edgesOf(large);
      const std::vector<BorderEdge> others = edgesOf(small);
      edges.insert(edges.end(), others.begin(), others.end());
      if (std::vector<BorderEdge> border = borderOf(edges); !border.empty())
      {
        borders.emplace(large, std::move(border));
        isGone[small] = 1;
        any = true;
      }
    }
    for (std::size_t p = 0; p < side_.count(); ++p)
    {
      if (isGone[p] == 0)
      {
        const auto border = borders.find(p);
        addPolygon(border != borders.end() ? border->second : edgesOf(p), side_.cellOf[p], united);
      }
    }
    side_ = std::move(united);
    return any;
  }

  std::vector<BorderEdge> edgesOf(std::size_t polygon) const
  {
    std::vector<BorderEdge> edges;
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
