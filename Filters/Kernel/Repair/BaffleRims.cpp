// SPDX-License-Identifier: BSD-3-Clause
#include "Repair/BaffleRims.h"

#include "Base/Rings.h"
#include "Lattice/NearestPlace.h"
#include "Repair/EdgePoints.h"
#include "Repair/NearbyTriangles.h"
#include "Repair/TriangleDivision.h"
#include "Repair/TrianglePlane.h"
#include "Surface/SurfaceEdges.h"

#include <algorithm>
#include <map>
#include <set>

namespace cartesian
{

namespace
{

using Triple = std::array<std::uint32_t, 3>;
using Ends = std::array<std::uint32_t, 2>; // of an edge, the lower first

// Corners this near to a vertex or an edge are on it: what single precision leaves.
constexpr double SnapLevels = 4096;

// A path along the walls follows an edge of the rim where it leads towards its end within this angle: cosine of 45
// degrees.
constexpr double LeastForward = 0.7;

// Walls turn at an edge where their normals differ by more than this: cosine of 30 degrees.
constexpr double LeastFlat = 0.87;

constexpr std::size_t MostSteps = 1 << 16;

Ends endsOf(std::uint32_t p, std::uint32_t q)
{
  return { std::min(p, q), std::max(p, q) };
}

Triple sorted(Triple t)
{
  std::sort(t.begin(), t.end());
  return t;
}

class RimJoiner
{
public:
  RimJoiner(Surface& surface, Surface& sheets, const RimSpec& spec)
    : surface_(surface)
    , sheets_(sheets)
    , tolerance_(std::max(spec.tolerance, SnapLevels))
    , sagitta_(spec.sagitta)
  {
    for (std::uint32_t t = 0; t < surface.triangles.size(); ++t)
    {
      for (const std::uint32_t v : surface.triangles[t])
      {
        trianglesAt_[v].push_back(t);
      }
    }
  }

  JoinedRims run(Execution& execution)
  {
    listRims(execution);
    const std::set<std::int32_t> regions(sheets_.region.begin(), sheets_.region.end());
    for (const std::int32_t region : regions)
    {
      attach(region);
    }
    JoinedRims result;
    result.any = !places_.empty();
    for (const RimEdge& edge : rims_)
    {
      if (!follow(edge))
      {
        paths_.erase({ edge.from, edge.to });
        result.all = false;
      }
    }
    divideWalls();
    divideSheets();
    return result;
  }

private:
  // As its triangle runs.
  struct RimEdge
  {
    std::uint32_t triangle;
    std::uint32_t from;
    std::uint32_t to;
  };

  // Where a corner of a rim is on the walls.
  struct Place
  {
    std::uint32_t vertex;
    std::vector<std::uint32_t> triangles; // that it lies in, or on the border of
  };

  // The points and edges that divide a triangle.
  struct Marks
  {
    std::vector<std::uint32_t> points;
    std::vector<Ends> edges;
  };

  void listRims(Execution& execution)
  {
    SurfaceEdges(sheets_, execution)
      .forEach([&](std::uint32_t lower, const EdgeUse* begin, const EdgeUse* end) {
        if (end - begin == 1)
        {
          const bool down = begin->down();
          rims_.push_back(
            { begin->triangle(), down ? begin->upper : lower, down ? lower : begin->upper });
        }
      });
  }

  // Finds the places of all corners of rims in a region.
  void attach(std::int32_t region)
  {
    std::vector<std::uint32_t> own;
    for (std::uint32_t t = 0; t < surface_.triangles.size(); ++t)
    {
      if (surface_.region[t] == region)
      {
        own.push_back(t);
      }
    }
    const NearbyTriangles nearby(surface_, own, tolerance_);
    for (const RimEdge& edge : rims_)
    {
      for (const std::uint32_t v : { edge.from, edge.to })
      {
        if (sheets_.region[edge.triangle] == region && places_.count(v) == 0)
        {
          const Vector at = toVector(surface_.vertices[v]);
          const auto nearest = nearby.find(at, [](std::uint32_t) { return true; });
          if (nearest.triangle != NearbyTriangles::None)
          {
            places_[v] = placeAt(nearest.triangle, at, v);
          }
        }
      }
    }
  }

  bool isOfSameRegion(std::uint32_t s, std::uint32_t t) const
  {
    return surface_.region[s] == surface_.region[t];
  }

  Place atVertex(std::uint32_t vertex, std::uint32_t like) const
  {
    Place place{ vertex, {} };
    for (const std::uint32_t t : trianglesAt_.at(vertex))
    {
      if (isOfSameRegion(t, like))
      {
        place.triangles.push_back(t);
      }
    }
    return place;
  }

  Place onEdge(const Ends& edge, std::uint32_t vertex, std::uint32_t like) const
  {
    Place place{ vertex, {} };
    for (const std::uint32_t t : atVertex(edge[0], like).triangles)
    {
      const Triple& c = surface_.triangles[t];
      if (std::find(c.begin(), c.end(), edge[1]) != c.end())
      {
        place.triangles.push_back(t);
      }
    }
    return place;
  }

  // Whether the walls turn at an edge of a triangle, so that a corner near it is near both.
  bool isSharp(const Ends& edge, std::uint32_t t) const
  {
    const Vector normal = normalOf(t);
    const std::vector<std::uint32_t> beside = onEdge(edge, edge[0], t).triangles;
    return std::any_of(beside.begin(), beside.end(),
      [&](std::uint32_t other) { return dot(normal, normalOf(other)) < LeastFlat; });
  }

  Vector normalOf(std::uint32_t t) const
  {
    const Corners c = surface_.corners(t);
    return unit(cross(minus(c[1], c[0]), minus(c[2], c[0])));
  }

  // The place on a triangle nearest to another; a vertex that is not the surface's moves there.
  Place placeAt(std::uint32_t t, const Vector& at, std::uint32_t vertex)
  {
    const Triple& c = surface_.triangles[t];
    const Vector nearest = nearestPlace(surface_.corners(t), at);
    std::array<double, 3> reach{}; // of edges
    for (std::size_t i = 0; i < 3; ++i)
    {
      reach[i] = isSharp(endsOf(c[i], following(c, i)), t) ? tolerance_ : SnapLevels;
    }
    for (std::size_t i = 0; i < 3; ++i)
    {
      // Where sharp edges meet, as near as they are.
      const double near = std::min(reach[i], preceding(reach, i));
      if (c[i] == vertex || norm(minus(toVector(surface_.vertices[c[i]]), nearest)) < near)
      {
        return atVertex(c[i], t);
      }
    }
    for (std::size_t i = 0; i < 3; ++i)
    {
      const Vector from = toVector(surface_.vertices[c[i]]);
      const Vector way = minus(toVector(surface_.vertices[following(c, i)]), from);
      const double along = std::clamp(dot(minus(nearest, from), way) / dot(way, way), 0., 1.);
      if (norm(minus(nearest, plus(from, scaled(way, along)))) < reach[i])
      {
        const Ends edge = endsOf(c[i], following(c, i));
        return onEdge(edge, vertexOn(edge, c[i] == edge[0] ? along : 1 - along), t);
      }
    }
    const std::uint32_t made = addVertex(nearest);
    marks_[sorted(c)].points.push_back(made);
    return { made, { t } };
  }

  std::uint32_t addVertex(const Vector& at)
  {
    surface_.vertices.push_back({ oddLevel(at[0]), oddLevel(at[1]), oddLevel(at[2]) });
    return static_cast<std::uint32_t>(surface_.vertices.size() - 1);
  }

  // The vertex of an edge there, made if need be.
  std::uint32_t vertexOn(const Ends& edge, double along)
  {
    const Vector from = toVector(surface_.vertices[edge[0]]);
    const Vector way = minus(toVector(surface_.vertices[edge[1]]), from);
    std::map<double, std::uint32_t>& known = onEdge_[edge];
    for (const auto& [place, vertex] : known)
    {
      if (std::abs(place - along) * norm(way) < SnapLevels)
      {
        return vertex;
      }
    }
    return known[along] = addVertex(plus(from, scaled(way, along)));
  }

  // The continuation of a path along the walls from a place.
  struct Step
  {
    double forward = 0; // cosine
    std::uint32_t triangle = 0;
    Ends edge{}; // that it leaves the triangle through; both ends the same: a vertex
    double along = 0;
  };

  struct Way
  {
    Vector from;
    Vector to;
    Vector normal; // of the sheet
    double sagitta;

    double heightOf(const Vector& at) const { return dot(minus(at, from), normal); }

    bool isNear(const Vector& at) const
    {
      const Vector whole = minus(to, from);
      const double along = std::clamp(dot(minus(at, from), whole) / dot(whole, whole), 0., 1.);
      return norm(minus(at, plus(from, scaled(whole, along)))) <
        std::max(sagitta * norm(whole), SnapLevels);
    }
  };

  static void consider(
    const Way& way, const Vector& here, const Vector& there, const Step& step, Step& best)
  {
    const Vector move = minus(there, here);
    const Vector left = minus(way.to, here);
    const double forward = dot(move, left) / std::max(norm(move) * norm(left), 1.);
    if (forward > std::max(best.forward, LeastForward) && norm(move) > 1 && way.isNear(there))
    {
      best = step;
      best.forward = forward;
    }
  }

  Step nextStep(const Way& way, const Place& place) const
  {
    const Vector here = toVector(surface_.vertices[place.vertex]);
    Step best;
    for (const std::uint32_t t : place.triangles)
    {
      const Triple& c = surface_.triangles[t];
      for (std::size_t i = 0; i < 3; ++i)
      {
        const Ends edge = endsOf(c[i], following(c, i));
        const Vector p = toVector(surface_.vertices[edge[0]]);
        const Vector q = toVector(surface_.vertices[edge[1]]);
        const double low = way.heightOf(p);
        const double high = way.heightOf(q);
        if (std::abs(low) < SnapLevels)
        {
          consider(way, here, p, { 0, t, { edge[0], edge[0] }, 0 }, best);
        }
        if (std::abs(high) < SnapLevels)
        {
          consider(way, here, q, { 0, t, { edge[1], edge[1] }, 0 }, best);
        }
        if (std::min(low, high) < -SnapLevels && std::max(low, high) > SnapLevels)
        {
          const double along = low / (low - high);
          consider(way, here, plus(p, scaled(minus(q, p), along)), { 0, t, edge, along }, best);
        }
      }
    }
    return best;
  }

  // Marks the path along the walls from one end of a rim's edge to the other. Returns false where there is none.
  bool follow(const RimEdge& edge)
  {
    const auto from = places_.find(edge.from);
    const auto to = places_.find(edge.to);
    if (from == places_.end() || to == places_.end())
    {
      return false;
    }
    const Place& end = to->second;
    Way way{ toVector(surface_.vertices[from->second.vertex]),
      toVector(surface_.vertices[end.vertex]), {}, sagitta_ };
    const Corners sheet{ surface_.vertices[sheets_.triangles[edge.triangle][0]],
      surface_.vertices[sheets_.triangles[edge.triangle][1]],
      surface_.vertices[sheets_.triangles[edge.triangle][2]] };
    way.normal = unit(cross(minus(sheet[1], sheet[0]), minus(sheet[2], sheet[0])));
    std::vector<std::uint32_t>& path = paths_[{ edge.from, edge.to }];
    Place here = from->second;
    for (std::size_t steps = 0; steps < MostSteps; ++steps)
    {
      const auto common = std::find_first_of(
        here.triangles.begin(), here.triangles.end(), end.triangles.begin(), end.triangles.end());
      if (common != here.triangles.end())
      {
        mark(*common, here.vertex, end.vertex);
        return true;
      }
      const Step step = nextStep(way, here);
      if (step.forward == 0)
      {
        return false;
      }
      Place next = step.edge[0] == step.edge[1]
        ? atVertex(step.edge[0], step.triangle)
        : onEdge(step.edge, vertexOn(step.edge, step.along), step.triangle);
      mark(step.triangle, here.vertex, next.vertex);
      if (next.vertex == end.vertex)
      {
        return true;
      }
      path.push_back(next.vertex);
      here = std::move(next);
    }
    return false;
  }

  void mark(std::uint32_t triangle, std::uint32_t from, std::uint32_t to)
  {
    marks_[sorted(surface_.triangles[triangle])].edges.push_back(endsOf(from, to));
  }

  // Replaces the triangles of a surface by what `divide` adds for each.
  template <class Divide>
  static void rebuild(Surface& surface, Divide&& divide)
  {
    Surface divided;
    for (std::uint32_t t = 0; t < surface.triangles.size(); ++t)
    {
      divide(t, divided.triangles);
      const std::size_t count = divided.triangles.size();
      divided.boundary.resize(count, surface.boundary[t]);
      divided.given.resize(count, surface.given[t]);
      divided.region.resize(count, surface.region[t]);
    }
    surface.takeTriangles(divided);
  }

  // Of all regions: those that have the same triangles keep the same.
  void divideWalls()
  {
    rebuild(surface_, [&](std::uint32_t t, std::vector<Triple>& parts) {
      const Triple& c = surface_.triangles[t];
      TriangleDivision division(
        surface_.vertices, c, static_cast<int>(axisOfNormal(surface_.corners(t))), {});
      for (std::size_t i = 0; i < 3; ++i)
      {
        division.divideEdge(i, pointsOn(onEdge_, c[i], following(c, i)));
      }
      const auto marks = marks_.find(sorted(c));
      if (marks != marks_.end())
      {
        for (const std::uint32_t point : marks->second.points)
        {
          division.addPoint(point);
        }
        for (const Ends& edge : marks->second.edges)
        {
          division.addEdge(edge[0], edge[1]);
        }
      }
      const std::vector<Triple>& made = division.finish();
      parts.insert(parts.end(), made.begin(), made.end());
    });
  }

  void divideSheets()
  {
    rebuild(sheets_, [&](std::uint32_t t, std::vector<Triple>& parts) {
      Triple c = sheets_.triangles[t];
      std::array<std::vector<std::uint32_t>, 3> paths;
      for (std::size_t i = 0; i < 3; ++i)
      {
        const auto path = paths_.find({ c[i], following(c, i) });
        paths[i] = path == paths_.end() ? std::vector<std::uint32_t>() : path->second;
      }
      for (std::uint32_t& v : c)
      {
        const auto place = places_.find(v);
        v = place == places_.end() ? v : place->second.vertex;
      }
      if (namesAVertexTwice(c))
      {
        return;
      }
      const Corners corners{ surface_.vertices[c[0]], surface_.vertices[c[1]],
        surface_.vertices[c[2]] };
      TriangleDivision division(surface_.vertices, c, static_cast<int>(axisOfNormal(corners)), {});
      for (std::size_t i = 0; i < 3; ++i)
      {
        division.divideEdge(i, paths[i]);
      }
      const std::vector<Triple>& made = division.finish();
      parts.insert(parts.end(), made.begin(), made.end());
    });
    sheets_.vertices = surface_.vertices;
  }

  Surface& surface_;
  Surface& sheets_;
  double tolerance_;
  double sagitta_;
  std::map<std::uint32_t, std::vector<std::uint32_t>> trianglesAt_; // of vertices
  std::vector<RimEdge> rims_;
  std::map<std::uint32_t, Place> places_; // of corners of rims
  EdgePoints onEdge_;
  std::map<Triple, Marks> marks_; // of walls, by their sorted corners
  std::map<std::array<std::uint32_t, 2>, std::vector<std::uint32_t>>
    paths_; // of edges of rims, between their ends
};

}

JoinedRims joinRims(Surface& surface, Surface& sheets, const RimSpec& spec, Execution& execution)
{
  return RimJoiner(surface, sheets, spec).run(execution);
}

}
