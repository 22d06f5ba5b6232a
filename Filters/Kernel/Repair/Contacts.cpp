// SPDX-License-Identifier: BSD-3-Clause
#include "Repair/Contacts.h"

#include "Lattice/NearestPlace.h"
#include "Repair/Arrangement.h"
#include "Repair/Curtains.h"
#include "Repair/NearbyTriangles.h"
#include "Repair/SpaceOwners.h"
#include "Repair/TrianglePairs.h"

#include <numeric>
#include <set>

namespace cartesian
{

namespace
{

// By the tolerance: how far one looks for another wall along a normal, which may lean.
constexpr double Reach = 1.5;

// Walls that end so close beside each other end together.
constexpr double Beside = 0.05;

// What is less aside is flush, by the tolerance.
constexpr double Flush = 1e-3;

// How far curtains reach into the other region: in turn, where some still cross, or walls do not close.
constexpr std::array<double, 4> Into{ 0.1, 0.03, 0.3, 1 };

// How often a part of an edge is made shorter by a third.
constexpr int Thirds = 30;

// Places of a triangle are so far from its corners, as a part of the way to its middle: not on rims.
constexpr double Inward = 0.02;

// In levels: places this close are in a triangle, and at the tolerance.
constexpr double Slack = 4;

using Triple = std::array<std::uint32_t, 3>;

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
    std::vector<std::vector<std::size_t>> triangles(static_cast<std::size_t>(regions) + 1);
    for (std::size_t t = 0; t < surface_.triangles.size(); ++t)
    {
      triangles[static_cast<std::size_t>(surface_.region[t])].push_back(t);
    }
    Surface divided;
    divided.vertices = surface_.vertices;
    for (std::int32_t region = FirstRegion; region <= regions; ++region)
    {
      Surface own;
      own.lattice = surface_.lattice;
      own.rounding = surface_.rounding;
      own.vertices.swap(divided.vertices);
      for (const std::size_t t : triangles[static_cast<std::size_t>(region)])
      {
        own.append(surface_, t);
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
    surface_.takeTriangles(divided);
  }

private:
  void findCuts()
  {
    const std::vector<std::int32_t> oneRegion;
    Curtains curtains(neighbours_, surface_, tolerance_, 0, oneRegion);
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
    const auto straight = [](const Vector&, const Vector& way, std::uint32_t) { return way; };
    curtains.hang(straight, height, [&](const Triple& strip, const Curtains::Curtain& curtain) {
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
      if (surface_.region[t] > surface_.region[own] && neighbours_.areFacing(own, t) &&
        isNear(edge, t))
      {
        faced.push_back(t);
      }
    });
    return faced;
  }

  // The distance of places along the edge has one minimum.
  bool isNear(const Neighbours::Edge& edge, std::uint32_t t) const
  {
    const Vector start = toVector(surface_.vertices[edge.ends[0]]);
    const Vector along = minus(surface_.vertices[edge.ends[1]], surface_.vertices[edge.ends[0]]);
    const Corners corners = surface_.corners(t);
    const auto distanceAt = [&](double part) {
      const Vector place = plus(start, scaled(along, part));
      return norm(minus(nearestPlace(corners, place), place));
    };
    double low = 0;
    double high = 1;
    for (int i = 0; i < Thirds; ++i)
    {
      const double third = (high - low) / 3;
      if (distanceAt(low + third) < distanceAt(high - third))
      {
        high -= third;
      }
      else
      {
        low += third;
      }
    }
    return distanceAt(low) <= tolerance_ + Slack;
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
  ContactOpener(Surface& surface, const ContactSpec& spec, Execution& execution)
    : surface_(surface)
    , neighbours_(surface, spec.tolerance, execution)
    , tolerance_(spec.tolerance)
    , boundaryOfCurtains_(spec.boundaryOfCurtains)
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
    const auto aim = [&](const Vector& place, const Vector& way, std::uint32_t own) {
      return aimAt(place, way, own);
    };
    curtains.hang(aim, height, [&](const Triple& triangle, const Curtains::Curtain& curtain) {
      append(surface_, curtain.beside, triangle, surface_);
      if (boundaryOfCurtains_ != ContactSpec::AsBeside)
      {
        surface_.boundary.back() = boundaryOfCurtains_ + curtain.towards;
      }
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

  // Within the edge of a wall that a rim on its way would miss, but no more than what ends together.
  Vector aimAt(const Vector& rim, const Vector& way, std::uint32_t own) const
  {
    const Vector place = plus(rim, scaled(minus(middleOf(surface_, own), rim), Inward));
    const Faced faced = facedAt(place, way, own);
    double aside = HUGE_VAL;
    Vector within{};
    const Vector reach = scaled(way, Reach * tolerance_);
    const Box box = boxAround(minus(rim, reach), plus(rim, reach), Beside * tolerance_);
    neighbours_.tree().forEachWithin(box.low, box.high, [&](std::uint32_t t) {
      const double lean = dot(neighbours_.normal(t), way);
      if (surface_.region[t] != faced.earlier || lean >= 0)
      {
        return;
      }
      const Corners c = surface_.corners(t);
      const double along = dot(neighbours_.normal(t), minus(toVector(c[0]), rim)) / lean;
      const Vector at = plus(rim, scaled(way, along));
      const Vector on = nearestPlace(c, at);
      if (std::abs(along) <= Reach * tolerance_ && norm(minus(on, at)) < aside)
      {
        const Vector inward = minus(middleOf(surface_, t), on);
        aside = norm(minus(on, at));
        within = plus(
          on, scaled(inward, std::min(1., Beside * tolerance_ / std::max(norm(inward), Slack))));
      }
    });
    const bool misses =
      faced.earlier != OutsideRegion && aside > Flush * tolerance_ && aside < HUGE_VAL;
    return misses ? unit(minus(within, rim)) : way;
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
    Faced first{ OutsideRegion, 2 * reach };
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
    surface_.takeTriangles(left);
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
  std::int32_t boundaryOfCurtains_;
  std::vector<std::int32_t> facing_; // of each triangle, or outside
  std::map<std::array<std::uint32_t, 2>, std::vector<Vector>>
    beside_; // of a vertex and a triangle: normals across sharp edges
  std::map<std::array<std::int32_t, 2>, ClosedContact> contacts_;
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
  const ContactSpec& spec, std::vector<ClosedContact>& contacts, Surface& arranged,
  std::vector<std::uint32_t>& crossing, Execution& execution)
{
  Surface divided = all;
  WallDivider(divided, spec.tolerance, execution).divide(bodies.regions, execution);
  Surface walls;
  for (const double into : Into)
  {
    arranged = divided;
    OpenedContacts opened = ContactOpener(arranged, spec, execution).open(bodies.regions, into);
    if (opened.contacts.empty())
    {
      break;
    }
    for (std::size_t t = 0; t < sheets.triangles.size(); ++t)
    {
      arranged.append(sheets, t);
    }
    arrange(arranged, execution);
    std::vector<Piece> pieces = piecesOf(arranged);
    const Spaces spaces = findOwners(arranged, pieces, bodies.regions, execution);
    crossing.clear();
    for (const std::uint32_t p : spaces.contradictions)
    {
      crossing.push_back(pieces[p].triangles[0]);
    }
    if (crossing.empty())
    {
      giveBoundaries(opened, Reach * spec.tolerance, spaces, arranged, pieces);
      walls = wallsBetween(arranged, bodies, pieces, spaces, execution);
      contacts = std::move(opened.contacts);
      listTriangles(all, contacts);
      break;
    }
  }
  return walls;
}

}
