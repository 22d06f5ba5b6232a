// SPDX-License-Identifier: BSD-3-Clause
#include "Repair/Contacts.h"

#include "Base/Rings.h"
#include "Lattice/NearestPlace.h"
#include "Repair/Arrangement.h"
#include "Repair/NearbyTriangles.h"
#include "Repair/TrianglePairs.h"
#include "Repair/TriangleTree.h"
#include "Surface/LineCrossings.h"
#include "Surface/Places.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <numeric>
#include <set>
#include <unordered_map>

namespace cartesian
{

namespace
{

// Between triangles of one wall, in degrees.
constexpr double SharpAngle = 45;

// Of curtains, and how far one looks for another wall along a normal, which may lean: by the tolerance.
constexpr double Reach = 1.5;

// Curtains lean at most so far from the wall's normal, in degrees; along narrower edges they stand on the wall.
// How far a curtain reaches into the other region at least, by the tolerance; places along an edge to measure it at.
const std::array<double, 4> Into{ 0.1, 0.03, 0.3, 1 };
constexpr double MostSteps = 64;

// Triangles whose normals differ by less are of one plane, whose normal is as exact as all of them are large.
constexpr double FlatLean = 3;

// Walls that end so close beside each other, by the tolerance, end together.
constexpr double Beside = 0.05;

constexpr double MostContradicting = 1e-5;

constexpr double MostTilt = 75;

constexpr double MostLean = 60;

// Normals whose sine is less are of one plane.
constexpr double OnePlane = 1e-4;

// Places of a triangle are so far from its corners, as a part of the way to its middle: not on rims.
constexpr double Inward = 0.02;

// In levels: places this close are in a triangle, and at the tolerance.
constexpr double Slack = 4;

using Triple = std::array<std::uint32_t, 3>;

// In Surface::region, where there are so many regions: beyond those of sheets (WallsOfBodies.h).
std::int32_t regionOfCurtains(std::int32_t region, std::int32_t regions)
{
  return regionOfSheets(regions + region, regions);
}

struct Box
{
  Vector low;
  Vector high;
};

Box boxAround(const Vector& p, const Vector& q, double reach)
{
  Box box;
  for (std::size_t axis = 0; axis < 3; ++axis)
  {
    box.low[axis] = std::min(p[axis], q[axis]) - reach;
    box.high[axis] = std::max(p[axis], q[axis]) + reach;
  }
  return box;
}

Vector areaVectorOf(const Corners& c)
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
std::vector<Vector> directionsAlong(const std::vector<Vector>& planes, const Vector& normal)
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
    const Triple& c = surface_.triangles[own];
    const bool isForward =
      (c[0] == a && c[1] == b) || (c[1] == a && c[2] == b) || (c[2] == a && c[0] == b);
    planned_.push_back({ { isForward ? a : b, isForward ? b : a }, own, beside, towards });
    for (const std::uint32_t v : edge.ends)
    {
      rims_[{ v, towards }].own = own;
      rims_[{ v, towards }].beside.push_back(
        neighbours_.normalAround(toVector(surface_.vertices[v]), beside, FlatLean));
    }
  }

  // Calls visit(triangle, curtain) for the triangles of all. They are as high as height(place, way, own) is at most
  // along their edges.
  template <class Height, class Visitor>
  void hang(Height&& height, Visitor&& visit)
  {
    for (auto& [key, rim] : rims_)
    {
      const Vector place = toVector(surface_.vertices[key.first]);
      rim.way =
        directionsAlong(rim.beside, neighbours_.normalAround(place, rim.own, MostLean, parts_))
          .back();
    }
    for (const Curtain& curtain : planned_)
    {
      measure(curtain, height);
    }
    for (auto& [key, rim] : rims_)
    {
      const Vector end = plus(toVector(surface_.vertices[key.first]), scaled(rim.way, rim.height));
      rim.end = static_cast<std::uint32_t>(surface_.vertices.size());
      surface_.vertices.push_back({ oddLevel(end[0]), oddLevel(end[1]), oddLevel(end[2]) });
    }
    for (const Curtain& curtain : planned_)
    {
      const auto [a, b] = curtain.edge;
      const std::uint32_t c = rims_[{ a, curtain.towards }].end;
      const std::uint32_t d = rims_[{ b, curtain.towards }].end;
      visit(Triple{ a, b, d }, curtain);
      visit(Triple{ a, d, c }, curtain);
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
    std::uint32_t own = 0;      // a triangle
    std::vector<Vector> beside; // normals
    Vector way{};
    double height = 0;
    std::uint32_t end = 0;
  };

  template <class Height>
  void measure(const Curtain& curtain, Height&& height)
  {
    Rim& from = rims_[{ curtain.edge[0], curtain.towards }];
    Rim& to = rims_[{ curtain.edge[1], curtain.towards }];
    const Vector start = toVector(surface_.vertices[curtain.edge[0]]);
    const Vector along = minus(toVector(surface_.vertices[curtain.edge[1]]), start);
    const double steps = std::clamp(std::ceil(norm(along) / step_), 1., MostSteps);
    for (double i = 0; i <= steps; ++i)
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

void append(const Surface& from, std::size_t like, const Triple& triangle, Surface& to)
{
  to.append(from, like);
  to.triangles.back() = triangle;
}

// Divides walls of later regions along strips on the borders of walls that they face.
class WallDivider
{
public:
  WallDivider(Surface& surface, double tolerance, Execution& execution)
    : surface_(surface)
    , neighbours_(surface, tolerance, execution)
    , tolerance_(tolerance)
  {
  }

  void divide(std::int32_t regions, Execution& execution)
  {
    findCuts();
    Surface divided;
    divided.vertices = surface_.vertices;
    for (std::int32_t region = FirstRegion; region <= regions; ++region)
    {
      Surface own;
      own.lattice = surface_.lattice;
      own.rounding = surface_.rounding;
      own.vertices.swap(divided.vertices);
      for (std::size_t t = 0; t < surface_.triangles.size(); ++t)
      {
        if (surface_.region[t] == region)
        {
          own.append(surface_, t);
        }
      }
      if (!cuts_[region].empty())
      {
        for (const Triple& cut : cuts_[region])
        {
          append(own, 0, cut, own);
          own.region.back() = OutsideRegion;
        }
        arrange(own, execution);
      }
      divided.vertices.swap(own.vertices);
      for (std::size_t t = 0; t < own.triangles.size(); ++t)
      {
        if (own.region[t] == region)
        {
          divided.append(own, t);
        }
      }
    }
    surface_.vertices.swap(divided.vertices);
    surface_.triangles.swap(divided.triangles);
    surface_.boundary.swap(divided.boundary);
    surface_.given.swap(divided.given);
    surface_.region.swap(divided.region);
  }

private:
  void findCuts()
  {
    const std::vector<std::int32_t> allOne;
    Curtains curtains(neighbours_, surface_, tolerance_, 0, allOne);
    std::map<std::uint32_t, std::vector<std::uint32_t>> faced; // of each triangle with a curtain
    for (const Neighbours::Edge& edge : neighbours_.edges())
    {
      if (neighbours_.isSharp(edge))
      {
        const std::array<std::vector<std::uint32_t>, 2> both{ laterWallsNear(edge, 0),
          laterWallsNear(edge, 1) };
        for (std::size_t i = 0; i < 2; ++i)
        {
          if (!both[i].empty() && both[1 - i].empty())
          {
            const std::uint32_t own = edge.triangles[i];
            curtains.plan(edge, own, edge.triangles[1 - i], surface_.region[both[i][0]]);
            faced[own].insert(faced[own].end(), both[i].begin(), both[i].end());
          }
        }
      }
    }
    const auto height = [&](const Vector&, const Vector&, std::uint32_t) {
      return Reach * tolerance_;
    };
    curtains.hang(height, [&](const Triple& strip, const Curtains::Curtain& curtain) {
      append(surface_, curtain.own, strip, surface_);
      const auto last = static_cast<std::uint32_t>(surface_.triangles.size() - 1);
      for (const std::uint32_t t : faced[curtain.own])
      {
        if (passesThrough(last, t))
        {
          cuts_[surface_.region[t]].insert(strip);
        }
      }
      surface_.triangles.pop_back();
      surface_.boundary.pop_back();
      surface_.given.pop_back();
      surface_.region.pop_back();
    });
  }

  // That one side of an edge faces.
  std::vector<std::uint32_t> laterWallsNear(const Neighbours::Edge& edge, std::size_t side)
  {
    const std::uint32_t own = edge.triangles[side];
    const Box box = boxAround(toVector(surface_.vertices[edge.ends[0]]),
      toVector(surface_.vertices[edge.ends[1]]), tolerance_);
    std::vector<std::uint32_t> faced;
    neighbours_.tree().forEachWithin(box.low, box.high, [&](std::uint32_t t) {
      if (surface_.region[t] > surface_.region[own] && isNearPlane(own, surface_.triangles[t]) &&
        isNearPlane(t, surface_.triangles[own]) && neighbours_.areFacing(own, t))
      {
        faced.push_back(t);
      }
    });
    return faced;
  }

  // Whether corners are within reach of a triangle's plane, or on both sides of it.
  bool isNearPlane(std::uint32_t t, const Triple& corners) const
  {
    const Point& base = surface_.vertices[surface_.triangles[t][0]];
    const auto height = [&](std::uint32_t v) {
      return dot(neighbours_.normal(t), minus(surface_.vertices[v], base));
    };
    const auto [low, high] =
      std::minmax({ height(corners[0]), height(corners[1]), height(corners[2]) });
    return low <= Reach * tolerance_ && high >= -Reach * tolerance_;
  }

  // Whether a strip divides a triangle, and does not run along its edges.
  bool passesThrough(std::uint32_t strip, std::uint32_t t) const
  {
    const Corners s = surface_.corners(strip);
    const Vector normal = unit(areaVectorOf(s));
    double low = 0;
    double high = 0;
    for (const Point& corner : surface_.corners(t))
    {
      const double height = dot(normal, minus(corner, s[0]));
      low = std::min(low, height);
      high = std::max(high, height);
    }
    const double least = Beside * tolerance_;
    return low < -least && high > least && contactOf(surface_, strip, t) == Contact::Crossing;
  }

  Surface& surface_;
  Neighbours neighbours_;
  double tolerance_;
  std::map<std::int32_t, std::set<Triple>> cuts_; // of each region
};

// Triangles that were taken away.
struct OpenedContacts
{
  Surface walls;
  std::vector<ClosedContact> contacts;
};

// Where a wall faces an earlier region.
struct Faced
{
  std::int32_t earlier = OutsideRegion;
  double gap = 0;      // along the normal; less than 0: an overlap
  double distance = 0; // the shortest
};

class ContactOpener
{
public:
  ContactOpener(Surface& surface, double tolerance, Execution& execution)
    : surface_(surface)
    , neighbours_(surface, tolerance, execution)
    , tolerance_(tolerance)
    , facing_(surface.triangles.size())
  {
  }

  OpenedContacts open(std::int32_t regions, double into)
  {
    findFacing();
    Curtains curtains(neighbours_, surface_, tolerance_, into * tolerance_, facing_);
    for (const Neighbours::Edge& edge : neighbours_.edges())
    {
      for (std::size_t i = 0; i < 2; ++i)
      {
        if (isRim(edge, i))
        {
          curtains.plan(edge, edge.triangles[i], edge.triangles[1 - i], facing_[edge.triangles[i]]);
        }
      }
    }
    const auto height = [&](const Vector& place, const Vector& way, std::uint32_t own) {
      const Vector inward = scaled(minus(middleOf(surface_, own), place), Inward);
      const Faced faced = facedAt(plus(place, inward), way, own);
      return faced.earlier == OutsideRegion ? 0 : std::max(0., faced.gap);
    };
    curtains.hang(height, [&](const Triple& triangle, const Curtains::Curtain& curtain) {
      append(surface_, curtain.beside, triangle, surface_);
      surface_.region.back() = regionOfCurtains(surface_.region.back(), regions);
    });
    return takeAway();
  }

private:
  void findFacing()
  {
    for (const Neighbours::Edge& edge : neighbours_.edges())
    {
      for (std::size_t i = 0; i < 2 && neighbours_.isSharp(edge); ++i)
      {
        for (const std::uint32_t v : edge.ends)
        {
          std::vector<Vector>& planes =
            beside_[{ v, static_cast<std::uint32_t>(surface_.region[edge.triangles[i]]) }];
          const Vector& normal = neighbours_.normal(edge.triangles[i]);
          if (std::none_of(planes.begin(), planes.end(),
                [&](const Vector& other) { return norm(cross(normal, other)) <= OnePlane; }))
          {
            planes.push_back(normal);
          }
        }
      }
    }
    for (std::uint32_t t = 0; t < facing_.size(); ++t)
    {
      facing_[t] = regionFacing(t);
    }
  }

  // Whether the triangle on that side of an edge goes, and the other is left, or goes elsewhere.
  bool isRim(const Neighbours::Edge& edge, std::size_t side) const
  {
    const std::int32_t own = facing_[edge.triangles[side]];
    const std::int32_t other = facing_[edge.triangles[1 - side]];
    return own != OutsideRegion && own != other &&
      (other == OutsideRegion || neighbours_.isSharp(edge));
  }

  // The earlier region that a triangle faces all over.
  std::int32_t regionFacing(std::uint32_t t)
  {
    const Corners c = surface_.corners(t);
    const Vector middle = middleOf(surface_, t);
    Vector normal{};
    std::vector<Faced> found;
    for (std::size_t i = 0; i < 4; ++i)
    {
      const Vector corner = i < 3 ? toVector(c[i]) : middle;
      std::vector<Vector> ways{ unit(normal) };
      if (i < 3)
      {
        const auto beside = beside_.find(
          { surface_.triangles[t][i], static_cast<std::uint32_t>(surface_.region[t]) });
        const std::vector<Vector> planes =
          beside == beside_.end() ? std::vector<Vector>() : beside->second;
        ways = directionsAlong(planes, neighbours_.normalAround(corner, t));
        const std::vector<Vector> own = directionsAlong(planes, neighbours_.normal(t));
        ways.insert(ways.end(), own.begin(), own.end());
      }
      const Vector place = plus(corner, scaled(minus(middle, corner), Inward));
      Faced faced;
      for (std::size_t k = 0; k < ways.size() && faced.earlier == OutsideRegion; ++k)
      {
        faced = facedAt(place, ways[k], t);
        normal = faced.earlier == OutsideRegion ? normal : plus(normal, ways[k]);
      }
      if (faced.earlier == OutsideRegion)
      {
        return OutsideRegion;
      }
      found.push_back(faced);
    }
    note(t, unit(normal), found);
    return found.back().earlier;
  }

  void note(std::uint32_t t, const Vector& normal, const std::vector<Faced>& found)
  {
    ClosedContact& contact = contacts_[{ found.back().earlier, surface_.region[t] }];
    const double part = norm(areaVectorOf(surface_.corners(t))) / 2 /
      static_cast<double>(found.size()) * dot(normal, neighbours_.normal(t));
    for (const Faced& faced : found)
    {
      contact.width = std::max(contact.width, faced.distance);
      (faced.gap > 0 ? contact.closed : contact.taken) += part * std::abs(faced.gap);
    }
  }

  // Of the walls that a place's normal meets first on the way out of the region, or into it if there is an overlap.
  Faced facedAt(const Vector& place, const Vector& normal, std::uint32_t own) const
  {
    const double reach = Reach * tolerance_;
    const Vector way = scaled(normal, reach);
    const Box box = boxAround(plus(place, way), minus(place, way), Slack);
    struct Hit
    {
      double along;
      std::uint32_t triangle;
    };
    std::map<std::int32_t, std::array<Hit, 2>>
      nearest; // of each region: behind the place and in front
    neighbours_.tree().forEachWithin(box.low, box.high, [&](std::uint32_t t) {
      const Vector& other = neighbours_.normal(t);
      const double lean = dot(other, normal);
      if (surface_.region[t] == surface_.region[own] || lean == 0)
      {
        return;
      }
      const Corners c = surface_.corners(t);
      const double along = dot(other, minus(toVector(c[0]), place)) / lean;
      const Vector at = plus(place, scaled(normal, along));
      if (std::abs(along) <= reach &&
        norm(minus(nearestPlace(c, at), at)) <= (lean < 0 ? Beside * tolerance_ : Slack))
      {
        auto& both = nearest
                       .emplace(surface_.region[t],
                         std::array<Hit, 2>{ Hit{ -2 * reach, t }, { 2 * reach, t } })
                       .first->second;
        Hit& hit = both[along < 0 ? 0 : 1];
        hit = std::abs(along) < std::abs(hit.along) ? Hit{ along, t } : hit;
      }
    });
    Faced first{ OutsideRegion, 2 * reach, 0 };
    for (const auto& [region, both] : nearest)
    {
      for (const Hit& hit : both)
      {
        if (std::abs(hit.along) <= reach && hit.along < first.gap &&
          dot(neighbours_.normal(hit.triangle), normal) < 0)
        {
          first = { region, hit.along, 0 };
        }
      }
    }
    first.distance = distanceTo(first.earlier, place, own);
    const bool isContact =
      first.earlier < surface_.region[own] && first.distance <= tolerance_ + Slack;
    return isContact ? first : Faced();
  }

  double distanceTo(std::int32_t region, const Vector& place, std::uint32_t own) const
  {
    double least = 2 * tolerance_;
    const Box box = boxAround(place, place, tolerance_ + Slack);
    neighbours_.tree().forEachWithin(box.low, box.high, [&](std::uint32_t t) {
      if (surface_.region[t] == region && dot(neighbours_.normal(own), neighbours_.normal(t)) < 0)
      {
        least = std::min(least, norm(minus(nearestPlace(surface_.corners(t), place), place)));
      }
    });
    return least;
  }

  OpenedContacts takeAway()
  {
    OpenedContacts opened;
    opened.walls.lattice = surface_.lattice;
    opened.walls.vertices = surface_.vertices;
    Surface left;
    for (std::uint32_t t = 0; t < surface_.triangles.size(); ++t)
    {
      const bool isTaken = t < facing_.size() && facing_[t] != OutsideRegion;
      (isTaken ? opened.walls : left).append(surface_, t);
      if (isTaken)
      {
        contacts_[{ facing_[t], surface_.region[t] }].given.push_back(surface_.given[t]);
      }
    }
    surface_.triangles.swap(left.triangles);
    surface_.boundary.swap(left.boundary);
    surface_.given.swap(left.given);
    surface_.region.swap(left.region);
    for (auto& [regions, contact] : contacts_)
    {
      contact.earlier = regions[0];
      contact.later = regions[1];
      opened.contacts.push_back(std::move(contact));
    }
    return opened;
  }

  Surface& surface_;
  Neighbours neighbours_;
  double tolerance_;
  std::vector<std::int32_t> facing_; // of each triangle, or outside
  std::map<std::array<std::uint32_t, 2>, std::vector<Vector>>
    beside_; // of a vertex and a triangle: normals across sharp edges
  std::map<std::array<std::int32_t, 2>, ClosedContact> contacts_;
};

// Which spaces are whose.
class SpaceOwners
{
public:
  SpaceOwners(const Surface& surface, const std::vector<Piece>& pieces, std::int32_t regions,
    Execution& execution)
    : surface_(surface)
    , pieces_(pieces)
    , regions_(regions)
    , flat_(flatOf(surface, pieces))
    , sides_(joinedSides(flat_, execution))
  {
    outside_ = static_cast<std::uint32_t>(2 * pieces.size());
    sides_.add();
    joinIslands(execution);
    owner_.resize(outside_ + 1);
  }

  Spaces find()
  {
    for (std::int32_t region = FirstRegion; region <= regions_; ++region)
    {
      findSpacesOf(region);
    }
    return spaces();
  }

private:
  // Where nothing joins parts of the surface, the side of one and the next along a line are of the same space.
  void joinIslands(Execution& execution)
  {
    std::vector<std::uint32_t> order(pieces_.size());
    std::vector<double> area(pieces_.size());
    DisjointSets parts(pieces_.size());
    std::map<std::uint32_t, std::uint32_t> first;
    for (std::uint32_t p = 0; p < order.size(); ++p)
    {
      order[p] = p;
      area[p] = norm(areaVectorOf(flat_.corners(p)));
      for (const bool front : { false, true })
      {
        parts.unite(p, first.emplace(sides_.find(sideOf(p, front)), p).first->second);
      }
    }
    std::stable_sort(order.begin(), order.end(),
      [&](std::uint32_t a, std::uint32_t b) { return area[a] > area[b]; });
    const TriangleTree tree(flat_, execution);
    std::set<std::uint32_t> joined;
    for (const std::uint32_t p : order)
    {
      if (joined.count(parts.find(p)) == 0 && joinAlongLine(p, tree))
      {
        joined.insert(parts.find(p));
      }
    }
  }

  bool joinAlongLine(std::uint32_t piece, const TriangleTree& tree)
  {
    const std::array<Wide, 3> normal = exactNormal(flat_.corners(piece));
    std::size_t along = 0;
    for (std::size_t axis = 1; axis < 3; ++axis)
    {
      const auto size = [&](std::size_t a) { return normal[a] < 0 ? -normal[a] : normal[a]; };
      along = size(axis) > size(along) ? axis : along;
    }
    const RowAxes& axes = RowsAlong[along];
    Vector low = middleOf(flat_, piece);
    const auto even = [&](int axis) {
      return static_cast<Level>(low[static_cast<std::size_t>(axis)] / 2) * 2;
    };
    const std::vector<Level> middles{ even(axes.middle) };
    const std::vector<Level> outers{ even(axes.outer) };
    low[static_cast<std::size_t>(axes.middle)] = middles[0];
    low[static_cast<std::size_t>(axes.outer)] = outers[0];
    Vector high = low;
    low[along] = 0;
    high[along] = 4294967295.;
    std::map<Level, std::vector<std::array<std::uint32_t, 2>>> hits; // sides: below and above
    bool isHit = false;
    tree.forEachWithin(low, high, [&](std::uint32_t p) {
      forEachLineCrossing(flat_.corners(p), axes, middles, outers,
        [&](std::size_t, std::size_t, const Point& at, bool up) {
          hits[at[along]].push_back({ sideOf(p, !up), sideOf(p, up) });
          isHit = isHit || p == piece;
        });
    });
    std::uint32_t below = outside_;
    bool isKnown = true;
    for (const auto& [level, at] : hits)
    {
      if (at.size() == 1 && isKnown)
      {
        sides_.unite(below, at[0][0]);
      }
      isKnown = at.size() == 1;
      below = at[0][1];
    }
    if (isKnown)
    {
      sides_.unite(below, outside_);
    }
    return isHit;
  }

  std::int32_t netOf(std::uint32_t piece, std::int32_t region) const
  {
    std::int32_t net = 0;
    for (const std::uint32_t t : pieces_[piece].triangles)
    {
      if (surface_.region[t] == region || surface_.region[t] == regionOfCurtains(region, regions_))
      {
        net += faceAlike(surface_.triangles[t], pieces_[piece].vertices) ? 1 : -1;
      }
    }
    return net;
  }

  // Spaces that no earlier region has are joined across the walls of others; the area of a region's own walls, those
  // that point out of a space less those that point into it, tells.
  void findSpacesOf(std::int32_t region)
  {
    DisjointSets spaces(outside_ + 1);
    std::vector<std::int32_t> net(pieces_.size());
    for (std::uint32_t p = 0; p < pieces_.size(); ++p)
    {
      const auto [behind, front] = beside(p);
      net[p] = netOf(p, region);
      if (net[p] == 0 && owner_[behind] == OutsideRegion && owner_[front] == OutsideRegion)
      {
        spaces.unite(behind, front);
      }
    }
    std::vector<double> inside(outside_ + 1);
    for (std::uint32_t p = 0; p < pieces_.size(); ++p)
    {
      const auto [behind, front] = beside(p);
      const double area = net[p] * norm(areaVectorOf(flat_.corners(p)));
      inside[spaces.find(behind)] += area;
      inside[spaces.find(front)] -= area;
    }
    const std::uint32_t around = spaces.find(sides_.find(outside_));
    for (std::uint32_t s = 0; s <= outside_; ++s)
    {
      const std::uint32_t space = spaces.find(s);
      if (owner_[s] == OutsideRegion && space != around && inside[space] > 0)
      {
        owner_[s] = region;
      }
    }
  }

  std::array<std::uint32_t, 2> beside(std::uint32_t piece)
  {
    return { sides_.find(sideOf(piece, false)), sides_.find(sideOf(piece, true)) };
  }

  // The pieces of regions that have no space of their own behind them, or one in front: unless these are slivers.
  std::vector<std::uint32_t> contradictions()
  {
    std::vector<std::uint32_t> all;
    double whole = 0;
    double part = 0;
    for (std::uint32_t p = 0; p < pieces_.size(); ++p)
    {
      const double area = norm(areaVectorOf(flat_.corners(p)));
      whole += area;
      if (contradicts(p))
      {
        all.push_back(p);
        part += area;
      }
    }
    return part > MostContradicting * whole ? all : std::vector<std::uint32_t>();
  }

  bool contradicts(std::uint32_t piece)
  {
    const auto [behind, front] = beside(piece);
    return std::any_of(
      pieces_[piece].triangles.begin(), pieces_[piece].triangles.end(), [&](std::uint32_t t) {
        const std::int32_t region = surface_.region[t];
        const bool isForward = faceAlike(surface_.triangles[t], pieces_[piece].vertices);
        const std::int32_t own = owner_[isForward ? behind : front];
        const std::int32_t other = owner_[isForward ? front : behind];
        return region <= regions_ && netOf(piece, region) != 0 &&
          (own == OutsideRegion || own > region || other == region);
      });
  }

  Spaces spaces()
  {
    Spaces result;
    std::map<std::uint32_t, std::uint32_t> number;
    for (std::uint32_t p = 0; p < pieces_.size(); ++p)
    {
      result.beside.push_back({});
      for (std::size_t i = 0; i < 2; ++i)
      {
        const std::uint32_t space = beside(p)[i];
        const auto [at, isNew] = number.emplace(space, static_cast<std::uint32_t>(number.size()));
        if (isNew)
        {
          result.turns.emplace_back(static_cast<std::size_t>(regions_) + 1);
          result.turns.back()[static_cast<std::size_t>(owner_[space])] = 1;
        }
        result.beside.back()[i] = at->second;
      }
    }
    result.contradictions = contradictions();
    return result;
  }

  const Surface& surface_;
  const std::vector<Piece>& pieces_;
  std::int32_t regions_;
  Surface flat_;
  DisjointSets sides_;
  std::uint32_t outside_ = 0;
  std::vector<std::int32_t> owner_; // of sets of sides
};

// Adds triangles that were taken away to the pieces that took their place, so that walls get their boundaries.
void giveBoundaries(const OpenedContacts& opened, double reach, const Spaces& spaces,
  Surface& arranged, std::vector<Piece>& pieces)
{
  std::vector<std::uint32_t> all(opened.walls.triangles.size());
  std::iota(all.begin(), all.end(), 0);
  const NearbyTriangles nearby(opened.walls, all, reach);
  const auto ownerOf = [&](std::uint32_t space) {
    const std::vector<std::int32_t>& turns = spaces.turns[space];
    return static_cast<std::int32_t>(std::find(turns.begin(), turns.end(), 1) - turns.begin());
  };
  for (std::size_t p = 0; p < pieces.size(); ++p)
  {
    const std::int32_t behind = ownerOf(spaces.beside[p][0]);
    const std::int32_t front = ownerOf(spaces.beside[p][1]);
    const std::int32_t later = std::max(behind, front);
    const auto isOwn = [&](std::uint32_t t) { return arranged.region[t] == later; };
    if (behind == front || std::min(behind, front) == OutsideRegion ||
      std::any_of(pieces[p].triangles.begin(), pieces[p].triangles.end(), isOwn))
    {
      continue;
    }
    const auto found = nearby.find(middleOf(arranged, pieces[p].triangles[0]),
      [&](std::uint32_t t) { return opened.walls.region[t] == later; });
    if (found.triangle != NearbyTriangles::None)
    {
      Triple c = pieces[p].vertices;
      if (front == later)
      {
        std::swap(c[1], c[2]);
      }
      pieces[p].triangles.push_back(static_cast<std::uint32_t>(arranged.triangles.size()));
      append(opened.walls, found.triangle, c, arranged);
    }
  }
}

// The user's triangles, undivided.
void listTriangles(const Surface& all, std::vector<ClosedContact>& contacts)
{
  for (ClosedContact& contact : contacts)
  {
    const std::set<std::uint32_t> given(contact.given.begin(), contact.given.end());
    contact.given.clear();
    for (std::size_t t = 0; t < all.triangles.size(); ++t)
    {
      if (all.region[t] == contact.later && given.count(all.given[t]) > 0)
      {
        contact.given.push_back(all.given[t]);
        contact.triangles.push_back(all.corners(t));
      }
    }
  }
}

}

Surface wallsWithContacts(const Surface& all, const Surface& sheets, const Bodies& bodies,
  double tolerance, std::vector<ClosedContact>& contacts, Surface& arranged,
  std::vector<std::uint32_t>& crossing, Execution& execution)
{
  Surface divided = all;
  WallDivider(divided, tolerance, execution).divide(bodies.regions, execution);
  Surface walls;
  for (const double into : Into)
  {
    arranged = divided;
    OpenedContacts opened =
      ContactOpener(arranged, tolerance, execution).open(bodies.regions, into);
    for (std::size_t t = 0; t < sheets.triangles.size(); ++t)
    {
      arranged.append(sheets, t);
    }
    arrange(arranged, execution);
    std::vector<Piece> pieces = piecesOf(arranged);
    const Spaces spaces = SpaceOwners(arranged, pieces, bodies.regions, execution).find();
    crossing.clear();
    for (const std::uint32_t p : spaces.contradictions)
    {
      crossing.push_back(pieces[p].triangles[0]);
    }
    if (crossing.empty())
    {
      giveBoundaries(opened, Reach * tolerance, spaces, arranged, pieces);
      walls = wallsBetween(arranged, bodies, pieces, spaces, execution);
      contacts = std::move(opened.contacts);
      listTriangles(all, contacts);
      break;
    }
  }
  return walls;
}

}
