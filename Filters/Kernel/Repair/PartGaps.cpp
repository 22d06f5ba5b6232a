// SPDX-License-Identifier: BSD-3-Clause
#include "Repair/PartGaps.h"

#include "Repair/Contacts.h"
#include "Repair/ManifoldComponents.h"
#include "Repair/SampleRays.h"
#include "Surface/Places.h"

#include <algorithm>
#include <map>
#include <set>

namespace cartesian
{

namespace
{

constexpr std::uint32_t NoPart = ~0u;

// What triangles of a surface are connected across edges.
class GivenBodies
{
public:
  GivenBodies(const Surface& surface, Execution& execution)
    : connected_(surface.triangles.size())
  {
    const SurfaceEdges edges(surface, execution);
    edges.forEach([&](std::uint32_t, const EdgeUse* begin, const EdgeUse* end) {
      for (const EdgeUse* use = begin; use != end; ++use)
      {
        connected_.unite(begin->triangle(), use->triangle());
      }
    });
    edges.forEach([&](std::uint32_t, const EdgeUse* begin, const EdgeUse* end) {
      if (end - begin != 2)
      {
        flawed_.insert(connected_.find(begin->triangle()));
      }
    });
    for (std::uint32_t t = 0; t < surface.given.size(); ++t)
    {
      triangleOf_.emplace(surface.given[t], t);
    }
  }

  // By a number in the view.
  std::uint32_t of(std::uint32_t given) { return connected_.find(triangleOf_.at(given)); }

  // Closed, and every edge of two triangles.
  bool isSound(std::uint32_t body) const { return flawed_.count(body) == 0; }

  // Numbers in the view.
  std::vector<std::uint32_t> trianglesOf(const std::set<std::uint32_t>& bodies)
  {
    std::vector<std::uint32_t> all;
    for (const auto& [given, t] : triangleOf_)
    {
      if (bodies.count(connected_.find(t)) > 0)
      {
        all.push_back(given);
      }
    }
    return all;
  }

private:
  DisjointSets connected_;
  std::set<std::uint32_t> flawed_;                    // bodies
  std::map<std::uint32_t, std::uint32_t> triangleOf_; // by numbers in the view
};

// The closed parts of a surface: shells that face out, with the cavities in them. A part is named by a triangle of its shell.
class ClosedParts
{
public:
  ClosedParts(const Surface& surface, const TriangleTree& tree, Execution& execution)
    : surface_(surface)
    , sheets_(surface, SurfaceEdges(surface, execution), execution)
    , part_(surface.triangles.size(), NoPart)
  {
    const Point base = surface.corners(0)[0];
    for (std::uint32_t t = 0; t < part_.size(); ++t)
    {
      const Corners c = surface.corners(t);
      volume_[sheets_.of(t)] +=
        dot(minus(c[0], base), cross(minus(c[1], c[0]), minus(c[2], c[0]))) / 6;
      if (sheets_.turned(t) || surface.isOfSheet(t) || !sheets_.closed(sheets_.of(t)))
      {
        excluded_.insert(sheets_.of(t));
      }
    }
    findCavities(tree, execution);
    for (std::uint32_t t = 0; t < part_.size(); ++t)
    {
      const std::uint32_t sheet = sheets_.of(t);
      const auto cavity = shellOf_.find(sheet);
      part_[t] = cavity != shellOf_.end() ? cavity->second : isShell(sheet) ? sheet : NoPart;
    }
  }

  std::uint32_t of(std::size_t triangle) const { return part_[triangle]; }

  void leaveOut(const std::set<std::uint32_t>& parts)
  {
    for (std::uint32_t& part : part_)
    {
      part = parts.count(part) > 0 ? NoPart : part;
    }
  }

  // In cubic levels, cavities included.
  double volume(std::uint32_t part) const { return volume_.at(part); }

private:
  bool isShell(std::uint32_t sheet) const
  {
    return excluded_.count(sheet) == 0 && volume_.at(sheet) > 0;
  }

  void findCavities(const TriangleTree& tree, Execution& execution)
  {
    const std::array<std::vector<SampleRay>, 3> rays = findSampleRays(surface_, sheets_, execution);
    for (std::size_t along = 0; along < 3; ++along)
    {
      for (const SampleRay& ray : rays[along])
      {
        if (ray.rank == 0 && excluded_.count(ray.sheet) == 0 && volume_.at(ray.sheet) < 0)
        {
          findShell(ray.sheet, crossingsOf(surface_, tree, along, ray.place));
        }
      }
    }
  }

  // The smallest that winds around the cavity.
  void findShell(std::uint32_t cavity, const std::vector<RayCrossing>& crossings)
  {
    std::map<std::uint32_t, int> turns;
    for (const RayCrossing& crossing : crossings)
    {
      const std::uint32_t sheet = sheets_.of(crossing.triangle);
      if (sheet == cavity)
      {
        break;
      }
      turns[sheet] += crossing.up ? -1 : 1;
    }
    for (const auto& [sheet, count] : turns)
    {
      if (count != 0 && isShell(sheet))
      {
        const auto [at, isNew] = shellOf_.emplace(cavity, sheet);
        at->second = isNew || volume_.at(sheet) < volume_.at(at->second) ? sheet : at->second;
      }
    }
  }

  const Surface& surface_;
  ManifoldComponents sheets_;
  std::map<std::uint32_t, double> volume_; // of sheets
  std::set<std::uint32_t> excluded_;
  std::map<std::uint32_t, std::uint32_t> shellOf_; // of cavities
  std::vector<std::uint32_t> part_;                // of each triangle
};

class PartJoiner
{
public:
  PartJoiner(const Surface& given, const Surface& surface, double width, Execution& execution)
    : surface_(surface)
    , width_(width)
    , execution_(execution)
    , tree_(surface, execution)
    , bodies_(given, execution)
    , parts_(surface, tree_, execution)
    , near_(surface.triangles.size())
    , boundaryOfStrips_(*std::max_element(surface.boundary.begin(), surface.boundary.end()) + 1)
  {
  }

  PartGaps join()
  {
    leaveOutFlawed();
    findNear();
    std::map<std::uint32_t, std::vector<std::uint32_t>> groups; // triangles
    for (std::uint32_t t = 0; t < surface_.triangles.size(); ++t)
    {
      if (parts_.of(t) != NoPart)
      {
        groups[near_.find(parts_.of(t))].push_back(t);
      }
    }
    for (const auto& [group, triangles] : groups)
    {
      joinGroup(triangles);
    }
    replace();
    return std::move(result_);
  }

private:
  // Parts that were no closed bodies before the repair.
  void leaveOutFlawed()
  {
    std::set<std::uint32_t> flawed;
    for (std::size_t t = 0; t < surface_.triangles.size(); ++t)
    {
      if (t >= surface_.given.size() || !bodies_.isSound(bodies_.of(surface_.given[t])))
      {
        flawed.insert(parts_.of(t));
      }
    }
    parts_.leaveOut(flawed);
  }

  // Parts with triangles that are near each other, by their bounds.
  void findNear()
  {
    for (std::uint32_t t = 0; t < surface_.triangles.size(); ++t)
    {
      if (parts_.of(t) == NoPart)
      {
        continue;
      }
      Vector low = toVector(surface_.corners(t)[0]);
      Vector high = low;
      for (const Point& corner : surface_.corners(t))
      {
        for (std::size_t axis = 0; axis < 3; ++axis)
        {
          low[axis] = std::min(low[axis], corner[axis] - width_);
          high[axis] = std::max(high[axis], corner[axis] + width_);
        }
      }
      tree_.forEachWithin(low, high, [&](std::uint32_t other) {
        if (parts_.of(other) != NoPart)
        {
          near_.unite(parts_.of(t), parts_.of(other));
        }
      });
    }
  }

  // The largest is the first region.
  std::vector<std::uint32_t> inOrder(const std::vector<std::uint32_t>& triangles) const
  {
    std::set<std::uint32_t> parts;
    for (const std::uint32_t t : triangles)
    {
      parts.insert(parts_.of(t));
    }
    std::vector<std::uint32_t> order(parts.begin(), parts.end());
    std::stable_sort(order.begin(), order.end(),
      [&](std::uint32_t a, std::uint32_t b) { return parts_.volume(a) > parts_.volume(b); });
    return order;
  }

  // Parts of which it is not certain what they enclose then stay as they are, and others are joined without them.
  void joinGroup(const std::vector<std::uint32_t>& triangles)
  {
    std::vector<std::uint32_t> parts = inOrder(triangles);
    while (parts.size() > 1)
    {
      const std::set<std::size_t> uncertain = joinRegions(triangles, parts);
      if (uncertain.empty())
      {
        return;
      }
      std::vector<std::uint32_t> left;
      for (std::size_t i = 0; i < parts.size(); ++i)
      {
        if (uncertain.count(i) == 0)
        {
          left.push_back(parts[i]);
        }
      }
      parts = std::move(left);
    }
  }

  // Returns those of the parts that are uncertain; if there are none, all are joined.
  std::set<std::size_t> joinRegions(
    const std::vector<std::uint32_t>& triangles, const std::vector<std::uint32_t>& parts)
  {
    std::map<std::uint32_t, std::int32_t> regions;
    for (const std::uint32_t part : parts)
    {
      regions.emplace(part, FirstRegion + static_cast<std::int32_t>(regions.size()));
    }
    std::vector<std::uint32_t> own;
    std::copy_if(triangles.begin(), triangles.end(), std::back_inserter(own),
      [&](std::uint32_t t) { return regions.count(parts_.of(t)) > 0; });
    Surface all = partOf(surface_, own);
    for (const std::uint32_t t : own)
    {
      all.region.push_back(regions.at(parts_.of(t)));
    }
    all.given.resize(all.triangles.size(), ClosesAHole);
    std::vector<ClosedContact> contacts;
    Surface arranged;
    std::vector<std::uint32_t> crossing;
    const Surface walls = wallsWithContacts(all, all.withoutTriangles(),
      { static_cast<std::int32_t>(parts.size()), {} }, { width_, boundaryOfStrips_ }, contacts,
      arranged, crossing, execution_);
    std::set<std::size_t> uncertain;
    for (const std::uint32_t t : crossing)
    {
      if (uncertain.insert(static_cast<std::size_t>(arranged.region[t] - FirstRegion)).second)
      {
        result_.refused.push_back(middleOf(arranged, t));
      }
    }
    if (crossing.empty() && !contacts.empty())
    {
      takeOutside(walls, contacts);
      joined_.insert(parts.begin(), parts.end());
    }
    return uncertain;
  }

  // What is left of the parts, and the strips, those that are connected as one gap.
  void takeOutside(const Surface& walls, const std::vector<ClosedContact>& contacts)
  {
    DisjointSets connected(walls.vertices.size());
    std::vector<std::size_t> strips;
    for (std::size_t t = 0; t < walls.triangles.size(); ++t)
    {
      const std::int32_t wall = walls.boundary[t];
      const std::uint32_t given = t < walls.given.size() ? walls.given[t] : ClosesAHole;
      if (walls.walls.front(wall) != OutsideRegion)
      {
        continue;
      }
      if (walls.walls.boundary(wall) >= boundaryOfStrips_)
      {
        connected.unite(walls.triangles[t][0], walls.triangles[t][1]);
        connected.unite(walls.triangles[t][0], walls.triangles[t][2]);
        strips.push_back(t);
      }
      else if (given != ClosesAHole)
      {
        result_.pieces.push_back({ given, walls.corners(t) });
      }
    }
    std::map<std::uint32_t, PartGaps::Gap> gaps;
    for (const std::size_t t : strips)
    {
      PartGaps::Gap& gap =
        gaps.emplace(connected.find(walls.triangles[t][0]), PartGaps::Gap{ 0, {} }).first->second;
      gap.strips.push_back(walls.corners(t));
      const std::int32_t wall = walls.boundary[t];
      const auto contact =
        std::find_if(contacts.begin(), contacts.end(), [&](const ClosedContact& one) {
          return one.later == walls.walls.behind(wall) &&
            one.earlier == walls.walls.boundary(wall) - boundaryOfStrips_;
        });
      gap.width = std::max(gap.width, contact != contacts.end() ? contact->width : 0);
    }
    for (auto& [vertex, gap] : gaps)
    {
      result_.gaps.push_back(std::move(gap));
    }
  }

  // All that is connected with parts that were joined, as bodies may have been united before.
  void replace()
  {
    std::set<std::uint32_t> bodies;
    for (const PartGaps::Piece& piece : result_.pieces)
    {
      bodies.insert(bodies_.of(piece.given));
    }
    for (std::size_t t = 0; t < surface_.given.size(); ++t)
    {
      if (joined_.count(parts_.of(t)) == 0 && !namesAVertexTwice(surface_.triangles[t]) &&
        bodies.count(bodies_.of(surface_.given[t])) > 0)
      {
        result_.pieces.push_back({ surface_.given[t], surface_.corners(t) });
      }
    }
    result_.replaced = bodies_.trianglesOf(bodies);
  }

  const Surface& surface_;
  double width_;
  Execution& execution_;
  TriangleTree tree_;
  GivenBodies bodies_;
  ClosedParts parts_;
  DisjointSets near_; // parts
  std::int32_t boundaryOfStrips_;
  std::set<std::uint32_t> joined_; // parts
  PartGaps result_;
};

}

PartGaps closePartGaps(
  const Surface& given, const Surface& surface, double width, Execution& execution)
{
  return surface.triangles.empty() ? PartGaps()
                                   : PartJoiner(given, surface, width, execution).join();
}

}
