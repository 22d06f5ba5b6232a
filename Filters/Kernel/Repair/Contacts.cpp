// SPDX-License-Identifier: BSD-3-Clause
#include "Repair/Contacts.h"

#include "Base/DisjointSets.h"
#include "Base/Rings.h"
#include "Repair/EdgePoints.h"
#include "Repair/NearbyTriangles.h"
#include "Surface/SurfaceEdges.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <set>

namespace cartesian
{

namespace
{

// Between triangles of one sheet, and of walls that face each other, in degrees.
constexpr double SharpAngle = 45;
constexpr double FacingAngle = 60;

// Triangles less high than this, in levels, lie along the rim; flips that get rid of all of them.
constexpr double Flat = 8;
constexpr int MostFlips = 16;

// A place on an edge that is nearer to an end than this part of the edge is the end.
constexpr double AtEnd = 0.01;

using Triangles = std::vector<std::uint32_t>;
using Loop = std::vector<std::uint32_t>; // vertices
using Triple = std::array<std::uint32_t, 3>;

// One pair of regions.
class ContactCloser
{
public:
  ContactCloser(Surface& surface, std::int32_t earlier, std::int32_t later, double tolerance,
    Execution& execution)
    : surface_(surface)
    , earlier_(earlier)
    , later_(later)
    , tolerance_(tolerance)
    , execution_(execution)
  {
  }

  // Closes the first contact that can be closed; false if there is none.
  bool closeOne(ClosedContact& contact)
  {
    findSheets();
    matchSheets();
    return std::any_of(groups_.begin(), groups_.end(),
      [&](const auto& group) { return close(group.second, contact); });
  }

private:
  // Sheets that face each other.
  struct Group
  {
    std::array<Triangles, 2> of; // of the earlier and the later region
    double width = 0;
  };

  std::size_t sideOf(std::uint32_t t) const { return surface_.region[t] == later_ ? 1 : 0; }
  bool isConcerned(std::uint32_t t) const
  {
    return surface_.region[t] == earlier_ || surface_.region[t] == later_;
  }

  Vector normalOf(std::uint32_t t) const
  {
    const Corners c = surface_.corners(t);
    return unit(cross(minus(c[1], c[0]), minus(c[2], c[0])));
  }

  // Numbers each triangle's sheet.
  void findSheets()
  {
    const double most = std::cos(radians(SharpAngle));
    DisjointSets sets(surface_.triangles.size());
    SurfaceEdges(surface_, execution_)
      .forEach([&](std::uint32_t, const EdgeUse* begin, const EdgeUse* end) {
        for (const std::int32_t region : { earlier_, later_ })
        {
          Triangles uses;
          for (const EdgeUse* use = begin; use != end; ++use)
          {
            if (surface_.region[use->triangle()] == region)
            {
              uses.push_back(use->triangle());
            }
          }
          if (uses.size() == 2 && dot(normalOf(uses[0]), normalOf(uses[1])) >= most)
          {
            sets.unite(uses[0], uses[1]);
          }
        }
      });
    for (std::uint32_t t = 0; t < surface_.triangles.size(); ++t)
    {
      if (isConcerned(t))
      {
        sheets_[sets.find(t)].push_back(t);
      }
    }
  }

  // Puts sheets that face each other all over together.
  void matchSheets()
  {
    std::array<Triangles, 2> all;
    std::map<std::uint32_t, std::uint32_t> sheetOf;
    for (const auto& [sheet, triangles] : sheets_)
    {
      for (const std::uint32_t t : triangles)
      {
        all[sideOf(t)].push_back(t);
        sheetOf[t] = sheet;
      }
    }
    const std::array<NearbyTriangles, 2> nearby{ NearbyTriangles(surface_, all[0], tolerance_),
      NearbyTriangles(surface_, all[1], tolerance_) };
    DisjointSets sets(surface_.triangles.size());
    std::set<std::uint32_t> unmatched;
    std::map<std::uint32_t, double> width;
    for (const auto& [sheet, triangles] : sheets_)
    {
      for (const std::uint32_t t : triangles)
      {
        for (const Vector& place : placesOf(t))
        {
          const auto found = facing(nearby[1 - sideOf(t)], t, place);
          if (found.triangle == NearbyTriangles::None)
          {
            unmatched.insert(sheet);
            break;
          }
          sets.unite(sheet, sheetOf[found.triangle]);
          width[sheet] = std::max(width[sheet], found.distance);
        }
        if (unmatched.count(sheet) > 0)
        {
          break;
        }
      }
    }
    std::set<std::uint32_t> open;
    for (const std::uint32_t sheet : unmatched)
    {
      open.insert(sets.find(sheet));
    }
    for (const auto& [sheet, triangles] : sheets_)
    {
      if (open.count(sets.find(sheet)) == 0)
      {
        Group& group = groups_[sets.find(sheet)];
        Triangles& side = group.of[sideOf(triangles.front())];
        side.insert(side.end(), triangles.begin(), triangles.end());
        group.width = std::max(group.width, width[sheet]);
      }
    }
  }

  // Corners, and the middle.
  std::array<Vector, 4> placesOf(std::uint32_t t) const
  {
    const Corners c = surface_.corners(t);
    std::array<Vector, 4> places{ toVector(c[0]), toVector(c[1]), toVector(c[2]), {} };
    places[3] = scaled(plus(places[0], plus(places[1], places[2])), 1. / 3);
    return places;
  }

  NearbyTriangles::Nearest facing(
    const NearbyTriangles& others, std::uint32_t t, const Vector& place) const
  {
    const double least = -std::cos(radians(FacingAngle));
    const Vector normal = normalOf(t);
    return others.find(
      place, [&](std::uint32_t other) { return dot(normal, normalOf(other)) <= least; });
  }

  // The borders of a part of a surface, along its triangles; none where it touches itself there.
  bool findLoops(const Triangles& part, std::vector<Loop>& loops) const
  {
    std::set<std::array<std::uint32_t, 2>> edges;
    for (const std::uint32_t t : part)
    {
      const auto& c = surface_.triangles[t];
      for (std::size_t i = 0; i < 3; ++i)
      {
        const std::uint32_t p = c[i];
        const std::uint32_t q = following(c, i);
        if (edges.erase({ q, p }) == 0)
        {
          edges.insert({ p, q });
        }
      }
    }
    std::map<std::uint32_t, std::uint32_t> next;
    for (const auto& [from, to] : edges)
    {
      if (!next.emplace(from, to).second)
      {
        return false;
      }
    }
    while (!next.empty())
    {
      Loop loop;
      for (auto at = next.begin(); at != next.end(); at = next.find(loop.back()))
      {
        loop.push_back(at->second);
        next.erase(at);
      }
      loops.push_back(loop);
    }
    return true;
  }

  // A place on a loop: on the edge from its i-th corner.
  struct OnLoop
  {
    std::size_t edge = 0;
    double along = 0; // part of the edge
    double distance = 0;

    double position() const { return static_cast<double>(edge) + along; }
  };

  OnLoop nearestOn(const Loop& loop, const Vector& place) const
  {
    OnLoop best;
    for (std::size_t i = 0; i < loop.size(); ++i)
    {
      const Vector from = toVector(surface_.vertices[loop[i]]);
      const Vector way = minus(toVector(surface_.vertices[following(loop, i)]), from);
      const double along =
        std::clamp(dot(way, minus(place, from)) / std::max(dot(way, way), 1.), 0., 1.);
      const double distance = norm(minus(plus(from, scaled(way, along)), place));
      if (i == 0 || distance < best.distance)
      {
        best = { i, along, distance };
      }
    }
    return best;
  }

  // The loop of `loops` that all corners of `loop` are near, or none.
  const Loop* matching(const Loop& loop, const std::vector<Loop>& loops, double& width) const
  {
    const auto isNear = [&](const Loop& other) {
      return std::all_of(loop.begin(), loop.end(), [&](std::uint32_t v) {
        return nearestOn(other, toVector(surface_.vertices[v])).distance <= tolerance_;
      });
    };
    const auto found = std::find_if(loops.begin(), loops.end(), isNear);
    if (found == loops.end())
    {
      return nullptr;
    }
    for (const std::uint32_t v : loop)
    {
      width = std::max(width, nearestOn(*found, toVector(surface_.vertices[v])).distance);
    }
    return &*found;
  }

  // Where a rim of the later region goes: for each of its corners the vertex, and those between it and the
  // next.
  struct Rim
  {
    Loop from;
    std::vector<Loop> to; // the first of each is for the corner itself
  };

  bool close(const Group& group, ClosedContact& contact)
  {
    std::array<std::vector<Loop>, 2> loops;
    if (group.of[0].empty() || group.of[1].empty() || areSame(group) ||
      !findLoops(group.of[0], loops[0]) || !findLoops(group.of[1], loops[1]) ||
      loops[0].size() != loops[1].size())
    {
      return false;
    }
    contact = { earlier_, later_, group.width, {}, {} };
    std::vector<Rim> rims;
    std::set<const Loop*> taken;
    onEdge_.clear();
    for (const Loop& loop : loops[1])
    {
      const Loop* const other = matching(loop, loops[0], contact.width);
      rims.push_back({ loop, {} });
      if (!other || !taken.insert(other).second || !zip(*other, rims.back()))
      {
        return false;
      }
    }
    for (const std::uint32_t t : group.of[1])
    {
      contact.given.push_back(surface_.given[t]);
      contact.triangles.push_back(surface_.corners(t));
    }
    exchange(group, rims);
    return true;
  }

  // Whether both sides have the same triangles.
  bool areSame(const Group& group) const
  {
    const auto verticesOf = [&](const Triangles& part) {
      std::set<Triple> all;
      for (const std::uint32_t t : part)
      {
        Triple c = surface_.triangles[t];
        std::sort(c.begin(), c.end());
        all.insert(c);
      }
      return all;
    };
    return verticesOf(group.of[0]) == verticesOf(group.of[1]);
  }

  // Finds where on the earlier region's rim each corner of the later one's goes, in turn.
  bool zip(Loop other, Rim& rim)
  {
    std::reverse(other.begin(), other.end()); // as the later region's runs
    const auto size = static_cast<double>(other.size());
    std::vector<double> position;
    for (const std::uint32_t v : rim.from)
    {
      OnLoop on = nearestOn(other, toVector(surface_.vertices[v]));
      on.along = on.along < AtEnd ? 0 : on.along > 1 - AtEnd ? 1 : on.along;
      position.push_back(std::fmod(on.position(), size));
    }
    double length = 0;
    std::vector<double> step(position.size());
    for (std::size_t i = 0; i < position.size(); ++i)
    {
      double& to = position[(i + 1) % position.size()];
      step[i] = std::fmod(to - position[i] + size, size);
      if (step[i] > size / 2 && i + 1 < position.size()) // back: stay
      {
        to = position[i];
        step[i] = 0;
      }
      length += step[i];
    }
    if (std::abs(length - size) > 0.5)
    {
      return false;
    }
    for (std::size_t i = 0; i < position.size(); ++i)
    {
      rim.to.push_back({ vertexAt(other, position[i]) });
      for (auto k = static_cast<std::size_t>(position[i]) + 1;
           static_cast<double>(k) < position[i] + step[i]; ++k)
      {
        rim.to.back().push_back(other[k % other.size()]);
      }
    }
    return true;
  }

  // The vertex at a place of a loop, made if need be.
  std::uint32_t vertexAt(const Loop& loop, double position)
  {
    const auto i = static_cast<std::size_t>(position);
    const double along = position - static_cast<double>(i);
    const std::uint32_t from = loop[i];
    const std::uint32_t to = following(loop, i);
    if (along == 0)
    {
      return from;
    }
    std::map<double, std::uint32_t>& onEdge = onEdge_[{ std::min(from, to), std::max(from, to) }];
    const auto [known, isNew] = onEdge.emplace(
      from < to ? along : 1 - along, static_cast<std::uint32_t>(surface_.vertices.size()));
    if (isNew)
    {
      const Vector start = toVector(surface_.vertices[from]);
      const Vector place =
        plus(start, scaled(minus(toVector(surface_.vertices[to]), start), along));
      surface_.vertices.push_back({ oddLevel(place[0]), oddLevel(place[1]), oddLevel(place[2]) });
    }
    return known->second;
  }

  // How the later region's triangles change at the rims.
  struct Moves
  {
    std::map<std::uint32_t, std::uint32_t> moved;
    std::map<std::array<std::uint32_t, 2>, Loop> between; // along its other side of the rim
  };

  static Moves movesOf(const std::vector<Rim>& rims)
  {
    Moves moves;
    for (const Rim& rim : rims)
    {
      for (std::size_t i = 0; i < rim.from.size(); ++i)
      {
        moves.moved[rim.from[i]] = rim.to[i].front();
        Loop& points = moves.between[{ rim.from[(i + 1) % rim.from.size()], rim.from[i] }];
        points.assign(rim.to[i].rbegin(), rim.to[i].rend() - 1);
      }
    }
    return moves;
  }

  // A triangle, divided at the points that its edges have got.
  std::vector<Triple> partsOf(std::uint32_t t, const Moves& moves) const
  {
    const bool isLater = surface_.region[t] == later_;
    Triple c = surface_.triangles[t];
    std::array<Loop, 3> onEdges;
    for (std::size_t i = 0; i < 3; ++i)
    {
      const auto found = moves.between.find({ c[i], following(c, i) });
      onEdges[i] = isLater && found != moves.between.end()
        ? found->second
        : pointsOn(onEdge_, c[i], following(c, i));
    }
    for (std::uint32_t& v : c)
    {
      const auto found = moves.moved.find(v);
      v = isLater && found != moves.moved.end() ? found->second : v;
    }
    std::vector<Triple> parts;
    divideAtEdges(c, onEdges, parts);
    return parts;
  }

  // The later region's side is replaced by the other; the rest of both is divided at the rims.
  void exchange(const Group& group, const std::vector<Rim>& rims)
  {
    const Moves moves = movesOf(rims);
    const NearbyTriangles own(surface_, group.of[1], 2 * tolerance_);
    const std::set<std::uint32_t> lost(group.of[1].begin(), group.of[1].end());
    const std::set<std::uint32_t> taken(group.of[0].begin(), group.of[0].end());
    Surface result;
    Triangles wall; // what the later region gets
    const auto add = [&](const Triple& triangle, std::uint32_t like, std::int32_t region) {
      if (!namesAVertexTwice(triangle))
      {
        result.triangles.push_back(triangle);
        result.boundary.push_back(surface_.boundary[like]);
        result.given.push_back(surface_.given[like]);
        result.region.push_back(region);
      }
    };
    for (std::uint32_t t = 0; t < surface_.triangles.size(); ++t)
    {
      if (lost.count(t) > 0)
      {
        continue;
      }
      for (const Triple& part : partsOf(t, moves))
      {
        add(part, t, surface_.region[t]);
        if (taken.count(t) > 0)
        {
          const Vector middle = scaled(
            plus(toVector(surface_.vertices[part[0]]),
              plus(toVector(surface_.vertices[part[1]]), toVector(surface_.vertices[part[2]]))),
            1. / 3);
          const auto like = own.find(middle, [](std::uint32_t) { return true; });
          wall.push_back(static_cast<std::uint32_t>(result.triangles.size()));
          add({ part[0], part[2], part[1] },
            like.triangle == NearbyTriangles::None ? group.of[1].front() : like.triangle, later_);
        }
      }
    }
    flipFlat(wall, result);
    surface_.triangles.swap(result.triangles);
    surface_.boundary.swap(result.boundary);
    surface_.given.swap(result.given);
    surface_.region.swap(result.region);
    onEdge_.clear();
  }

  // Corners that went to one straight edge of the earlier rim leave flat triangles there: the edge opposite to
  // the middle one goes to the triangle behind it.
  void flipFlat(const Triangles& wall, Surface& result) const
  {
    const std::set<std::uint32_t> fixed(wall.begin(), wall.end());
    bool isDone = false;
    for (int round = 0; round < MostFlips && !isDone; ++round)
    {
      std::map<std::array<std::uint32_t, 2>, std::uint32_t> triangleAt;
      for (std::uint32_t t = 0; t < result.triangles.size(); ++t)
      {
        for (std::size_t i = 0; i < 3 && result.region[t] == later_ && fixed.count(t) == 0; ++i)
        {
          triangleAt[{ result.triangles[t][i], result.triangles[t][(i + 1) % 3] }] = t;
        }
      }
      isDone = true;
      std::set<std::uint32_t> changed;
      for (const auto& [edge, t] : triangleAt)
      {
        const auto other = triangleAt.find({ edge[1], edge[0] });
        const std::uint32_t middle = opposite(result.triangles[t], edge);
        if (other == triangleAt.end() || !liesAlong(edge, middle) || changed.count(t) > 0 ||
          changed.count(other->second) > 0)
        {
          continue;
        }
        const std::uint32_t end = opposite(result.triangles[other->second], other->first);
        if (triangleAt.count({ middle, end }) == 0 && triangleAt.count({ end, middle }) == 0)
        {
          result.triangles[t] = { edge[0], end, middle };
          result.triangles[other->second] = { end, edge[1], middle };
          changed.insert({ t, other->second });
          isDone = false;
        }
      }
    }
  }

  static std::uint32_t opposite(const Triple& c, const std::array<std::uint32_t, 2>& edge)
  {
    return *std::find_if(
      c.begin(), c.end(), [&](std::uint32_t v) { return v != edge[0] && v != edge[1]; });
  }

  // Whether a vertex lies on an edge up to a few levels.
  bool liesAlong(const std::array<std::uint32_t, 2>& edge, std::uint32_t vertex) const
  {
    const Vector way = minus(surface_.vertices[edge[1]], surface_.vertices[edge[0]]);
    const Vector to = minus(surface_.vertices[vertex], surface_.vertices[edge[0]]);
    const double along = dot(way, to) / std::max(dot(way, way), 1.);
    return along > 0 && along < 1 && norm(minus(to, scaled(way, along))) < Flat;
  }

  Surface& surface_;
  std::int32_t earlier_;
  std::int32_t later_;
  double tolerance_;
  Execution& execution_;
  std::map<std::uint32_t, Triangles> sheets_;
  std::map<std::uint32_t, Group> groups_;
  EdgePoints onEdge_;
};

}

std::vector<ClosedContact> closeContacts(
  Surface& surface, std::int32_t regions, double tolerance, Execution& execution)
{
  std::vector<ClosedContact> closed;
  for (std::int32_t later = FirstRegion + 1; later <= regions; ++later)
  {
    for (std::int32_t earlier = FirstRegion; earlier < later; ++earlier)
    {
      ClosedContact contact;
      while (ContactCloser(surface, earlier, later, tolerance, execution).closeOne(contact))
      {
        closed.push_back(contact);
      }
    }
  }
  return closed;
}

}
