// SPDX-License-Identifier: BSD-3-Clause
// Strips that stand on the rims of walls, across the gap to another region (Contacts.h).
//
// A strip runs along the walls beside the rim, as far as these do not lean too much: so what is flush stays flat. The
// normals of these are means over all that is in one plane with them, as those of small triangles are not exact. In levels.
// The method is the project's own.
#pragma once

#include "Lattice/Vector.h"
#include "Repair/TriangleTree.h"
#include "Surface/Places.h"
#include "Surface/SurfaceEdges.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <unordered_map>

namespace cartesian
{

// In degrees: between triangles that meet in a sharp edge; of one wall, however rough; of one plane; and of a strip from the
// normal of its wall, on which it stands if those beside the rim lean more.
constexpr double SharpAngle = 45;
constexpr double MostLean = 60;
constexpr double FlatLean = 3;
constexpr double MostTilt = 75;

// Normals whose sine is less are of one plane.
constexpr double OnePlane = 1e-4;

// Places along an edge at which strips are measured.
constexpr double MostSteps = 64;

struct Box
{
  Vector low;
  Vector high;
};

inline Box boxAround(const Vector& p, const Vector& q, double reach)
{
  Box box;
  for (std::size_t axis = 0; axis < 3; ++axis)
  {
    box.low[axis] = std::min(p[axis], q[axis]) - reach;
    box.high[axis] = std::max(p[axis], q[axis]) + reach;
  }
  return box;
}

inline Vector areaVectorOf(const Corners& c)
{
  return cross(minus(c[1], c[0]), minus(c[2], c[0]));
}

// Triangles of all regions with their neighbours.
class Neighbours
{
public:
  struct Edge
  {
    std::array<std::uint32_t, 2> ends;
    std::array<std::uint32_t, 2> triangles; // of the same region
  };

  Neighbours(const Surface& surface, double tolerance, Execution& execution)
    : surface_(surface)
    , tolerance_(tolerance)
    , tree_(surface, execution)
  {
    for (std::size_t t = 0; t < surface.triangles.size(); ++t)
    {
      normals_.push_back(unit(areaVectorOf(surface.corners(t))));
    }
    SurfaceEdges(surface_, execution)
      .forEach([&](std::uint32_t lower, const EdgeUse* begin, const EdgeUse* end) {
        std::map<std::int32_t, std::vector<std::uint32_t>> uses;
        for (const EdgeUse* use = begin; use != end; ++use)
        {
          uses[surface_.region[use->triangle()]].push_back(use->triangle());
        }
        for (const auto& [region, both] : uses)
        {
          if (both.size() == 2)
          {
            edges_.push_back({ { lower, begin->upper }, { both[0], both[1] } });
          }
        }
      });
  }

  const std::vector<Edge>& edges() const { return edges_; }
  const TriangleTree& tree() const { return tree_; }
  const Vector& normal(std::uint32_t t) const { return normals_[t]; }

  bool isSharp(const Edge& edge) const
  {
    return dot(normals_[edge.triangles[0]], normals_[edge.triangles[1]]) <
      std::cos(radians(SharpAngle));
  }

  // Whether two walls do, however rough they are.
  bool areFacing(std::uint32_t s, std::uint32_t t)
  {
    return surface_.region[s] != surface_.region[t] &&
      dot(meanNormal(s), meanNormal(t)) <= -std::cos(radians(MostLean));
  }

  // In the mean around a place, of triangles of the same part that do not lean more from one than this, in degrees.
  Vector normalAround(const Vector& place, std::uint32_t own, double mostLean = MostLean,
    const std::vector<std::int32_t>& parts = {}) const
  {
    const double least = std::cos(radians(mostLean));
    Vector sum{};
    const Box box = boxAround(place, place, tolerance_);
    tree_.forEachWithin(box.low, box.high, [&](std::uint32_t t) {
      if (surface_.region[t] == surface_.region[own] && dot(normals_[t], normals_[own]) >= least &&
        (parts.empty() || parts[t] == parts[own]))
      {
        sum = plus(sum, areaVectorOf(surface_.corners(t)));
      }
    });
    return unit(sum);
  }

private:
  const Vector& meanNormal(std::uint32_t t)
  {
    const auto [at, isNew] = means_.emplace(t, Vector());
    if (isNew)
    {
      at->second = normalAround(middleOf(surface_, t), t);
    }
    return at->second;
  }

  const Surface& surface_;
  double tolerance_;
  TriangleTree tree_;
  std::vector<Vector> normals_;
  std::vector<Edge> edges_;
  std::unordered_map<std::uint32_t, Vector> means_;
};

// The directions nearest to a normal that run along these planes, by their normals: along none, each, and each two.
inline std::vector<Vector> directionsAlong(const std::vector<Vector>& planes, const Vector& normal)
{
  std::vector<Vector> all{ normal };
  const auto add = [&](const Vector& way) {
    if (norm(way) > OnePlane && dot(way, normal) >= norm(way) * std::cos(radians(MostTilt)))
    {
      all.push_back(unit(way));
    }
  };
  for (const Vector& plane : planes)
  {
    add(minus(normal, scaled(plane, dot(normal, plane))));
  }
  for (std::size_t i = 0; i < planes.size(); ++i)
  {
    for (std::size_t j = 0; j < i; ++j)
    {
      const Vector line = cross(planes[i], planes[j]);
      add(norm(line) > OnePlane ? scaled(unit(line), dot(unit(line), normal)) : Vector());
    }
  }
  return all;
}

// Strips that stand on the border of parts of a surface.
class Curtains
{
public:
  // `into`: how far beyond what hang() asks for.
  Curtains(const Neighbours& neighbours, Surface& surface, double tolerance, double into,
    const std::vector<std::int32_t>& parts)
    : neighbours_(neighbours)
    , surface_(surface)
    , step_(tolerance / 4)
    , into_(into)
    , parts_(parts)
  {
  }

  // Puts one on an edge of the part's triangle `own`, as that uses it; other triangles are `beside` it. At a vertex, those
  // towards the same region are joined.
  void plan(
    const Neighbours::Edge& edge, std::uint32_t own, std::uint32_t beside, std::int32_t towards)
  {
    auto [a, b] = edge.ends;
    const auto& c = surface_.triangles[own];
    const bool isForward =
      (c[0] == a && c[1] == b) || (c[1] == a && c[2] == b) || (c[2] == a && c[0] == b);
    planned_.push_back({ { isForward ? a : b, isForward ? b : a }, own, beside, towards });
    for (const std::uint32_t v : edge.ends)
    {
      addOwn(own, rims_[{ v, towards }].own);
      rims_[{ v, towards }].beside.push_back(
        neighbours_.normalAround(toVector(surface_.vertices[v]), beside, FlatLean));
    }
  }

  // Calls visit(triangle, curtain) for the triangles of all. They stand at rims along aim(place, way, own), where `way` is along
  // the walls, and are as high as height(place, way, own) is at most along their edges.
  template <class Aim, class Height, class Visitor>
  void hang(Aim&& aim, Height&& height, Visitor&& visit)
  {
    for (auto& [key, rim] : rims_)
    {
      const Vector place = toVector(surface_.vertices[key.first]);
      Vector normal{};
      for (const std::uint32_t own : rim.own)
      {
        normal = plus(normal, neighbours_.normalAround(place, own, MostLean, parts_));
      }
      rim.way = aim(place, directionsAlong(rim.beside, unit(normal)).back(), rim.own.front());
    }
    for (const Curtain& curtain : planned_)
    {
      measure(curtain, height);
    }
    for (auto& [key, rim] : rims_)
    {
      const Vector end = endOf(toVector(surface_.vertices[key.first]), rim);
      rim.end = static_cast<std::uint32_t>(surface_.vertices.size());
      surface_.vertices.push_back({ oddLevel(end[0]), oddLevel(end[1]), oddLevel(end[2]) });
    }
    for (const Curtain& curtain : planned_)
    {
      const auto [a, b] = curtain.edge;
      const std::uint32_t c = rims_[{ a, curtain.towards }].end;
      const std::uint32_t d = rims_[{ b, curtain.towards }].end;
      visit(std::array<std::uint32_t, 3>{ a, b, d }, curtain);
      visit(std::array<std::uint32_t, 3>{ a, d, c }, curtain);
    }
  }

  struct Curtain
  {
    std::array<std::uint32_t, 2> edge;
    std::uint32_t own;
    std::uint32_t beside;
    std::int32_t towards;
  };

private:
  struct Rim
  {
    std::vector<std::uint32_t> own; // triangles, one of each side of a sharp edge
    std::vector<Vector> beside;     // normals
    Vector way{};
    double height = 0;
    std::uint32_t end = 0;
  };

  // On the lattice.
  static Vector endOf(const Vector& place, const Rim& rim)
  {
    double height = rim.height;
    for (std::size_t axis = 0; axis < 3; ++axis)
    {
      const double room = rim.way[axis] < 0 ? place[axis] - 1 : LevelsOfTheDomain - place[axis];
      height = std::min(height, rim.way[axis] == 0 ? height : room / std::abs(rim.way[axis]));
    }
    return plus(place, scaled(rim.way, height));
  }

  // A corner of walls that face another all around it gets a way between them.
  void addOwn(std::uint32_t triangle, std::vector<std::uint32_t>& all) const
  {
    const auto isLike = [&](std::uint32_t other) {
      return dot(neighbours_.normal(other), neighbours_.normal(triangle)) >=
        std::cos(radians(SharpAngle));
    };
    if (std::none_of(all.begin(), all.end(), isLike))
    {
      all.push_back(triangle);
    }
  }

  template <class Height>
  void measure(const Curtain& curtain, Height&& height)
  {
    Rim& from = rims_[{ curtain.edge[0], curtain.towards }];
    Rim& to = rims_[{ curtain.edge[1], curtain.towards }];
    const Vector start = toVector(surface_.vertices[curtain.edge[0]]);
    const Vector along = minus(toVector(surface_.vertices[curtain.edge[1]]), start);
    const double steps = std::clamp(std::ceil(norm(along) / step_), 1., MostSteps);
    for (int i = 0; i <= static_cast<int>(steps); ++i)
    {
      const double part = i / steps;
      const Vector way = unit(plus(scaled(from.way, 1 - part), scaled(to.way, part)));
      const double high = height(plus(start, scaled(along, part)), way, curtain.own);
      from.height = std::max(from.height, high + into_);
      to.height = std::max(to.height, high + into_);
    }
  }

  const Neighbours& neighbours_;
  Surface& surface_;
  double step_;                            // along edges
  double into_;                            // how far curtains reach beyond
  const std::vector<std::int32_t>& parts_; // of triangles
  std::vector<Curtain> planned_;
  std::map<std::pair<std::uint32_t, std::int32_t>, Rim> rims_; // at vertices
};

}
