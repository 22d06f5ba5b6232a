// SPDX-License-Identifier: BSD-3-Clause
#include "Mesher/ClosedGaps.h"

#include "Base/DisjointSets.h"
#include "Base/Sorting.h"
#include "Mesher/Mesher.h"
#include "Mesher/ViewWithGaps.h"
#include "Repair/PartGaps.h"
#include "Repair/StripEnds.h"
#include "Surface/Places.h"
#include "Surface/SurfaceEdges.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <set>

namespace cartesian
{

namespace
{

// The points of the view by their places, and others.
class Points
{
public:
  Points(const Lattice& lattice, const SurfaceView& view)
    : lattice_(lattice)
    , count_(view.pointCount)
  {
    for (std::size_t corner = 0; corner < 3 * view.triangleCount; ++corner)
    {
      const std::uint32_t p = view.triangles[corner];
      Point place;
      for (int axis = 0; axis < 3; ++axis)
      {
        place[static_cast<std::size_t>(axis)] =
          lattice_.vertex(axis, view.points[3 * std::size_t(p) + std::size_t(axis)]);
      }
      std::uint32_t& lowest = at_.emplace(place, p).first->second;
      lowest = std::min(lowest, p);
    }
  }

  // A new one where there is none.
  std::uint32_t at(const Point& place)
  {
    const auto [found, isNew] =
      at_.emplace(place, static_cast<std::uint32_t>(count_ + added_.size() / 3));
    for (int axis = 0; axis < 3 && isNew; ++axis)
    {
      added_.push_back(lattice_.position(axis, place[static_cast<std::size_t>(axis)]));
    }
    return found->second;
  }

  std::array<std::uint32_t, 3> at(const Corners& c) { return { at(c[0]), at(c[1]), at(c[2]) }; }

  std::vector<double> takeAdded() { return std::move(added_); }

private:
  const Lattice& lattice_;
  std::size_t count_; // of the view
  std::map<Point, std::uint32_t> at_;
  std::vector<double> added_;
};

Surface ofRegion(const Surface& all, std::int32_t region)
{
  Surface own;
  own.lattice = all.lattice;
  own.vertices = all.vertices;
  for (std::size_t t = 0; t < all.triangles.size(); ++t)
  {
    if (all.region[t] == region && !namesAVertexTwice(all.triangles[t]))
    {
      own.append(all, t);
    }
  }
  own.region.clear();
  return own;
}

// The parts of a surface that meet others only where three triangles or more share an edge.
class Parts
{
public:
  Parts(Surface surface, Execution& execution)
    : surface_(std::move(surface))
    , connected_(surface_.triangles.size())
  {
    const SurfaceEdges edges(surface_, execution);
    edges.forEach([&](std::uint32_t, const EdgeUse* begin, const EdgeUse* end) {
      if (end - begin == 2)
      {
        connected_.unite(begin[0].triangle(), begin[1].triangle());
      }
    });
    edges.forEach([&](std::uint32_t lower, const EdgeUse* begin, const EdgeUse* end) {
      for (const EdgeUse* use = begin; end - begin != 2 && use != end; ++use)
      {
        const std::uint32_t part = connected_.find(use->triangle());
        parts_[{ lower, begin->upper }].push_back(part);
        ++endings_[part];
      }
    });
  }

  // The triangles of the view in the smallest part whose edge is a rim that parts meet at; none: at an edge there is nothing but
  // the hole.
  std::vector<std::uint32_t> closing(const std::vector<std::uint32_t>& rim)
  {
    std::map<std::uint32_t, std::size_t> edgesOf; // of the rim, by part
    for (std::size_t i = 0; i < rim.size(); ++i)
    {
      const std::uint32_t next = rim[(i + 1) % rim.size()];
      const auto found = parts_.find({ std::min(rim[i], next), std::max(rim[i], next) });
      if (found == parts_.end() || found->second.size() < 3)
      {
        return {};
      }
      for (const std::uint32_t part : found->second)
      {
        ++edgesOf[part];
      }
    }
    std::vector<std::uint32_t> smallest;
    double least = HUGE_VAL;
    for (const auto& [part, edges] : edgesOf)
    {
      if (edges == rim.size() && endings_[part] == edges)
      {
        const std::vector<std::uint32_t> all = trianglesOf(part);
        if (const double area = areaOf(all); area < least)
        {
          least = area;
          smallest = all;
        }
      }
    }
    std::transform(smallest.begin(), smallest.end(), smallest.begin(),
      [&](std::uint32_t t) { return surface_.given[t]; });
    return smallest;
  }

private:
  std::vector<std::uint32_t> trianglesOf(std::uint32_t part)
  {
    std::vector<std::uint32_t> all;
    for (std::uint32_t t = 0; t < surface_.triangles.size(); ++t)
    {
      if (connected_.find(t) == part)
      {
        all.push_back(t);
      }
    }
    return all;
  }

  double areaOf(const std::vector<std::uint32_t>& triangles) const
  {
    double area = 0;
    for (const std::uint32_t t : triangles)
    {
      area += cartesian::areaOf(surface_, t);
    }
    return area;
  }

  Surface surface_;
  DisjointSets connected_;
  std::map<std::array<std::uint32_t, 2>, std::vector<std::uint32_t>>
    parts_;                                      // at edges of others than two
  std::map<std::uint32_t, std::size_t> endings_; // such edges of each part
};

// The border that starts at the lowest point which has one.
std::vector<std::uint32_t> loopAround(const std::vector<std::array<std::uint32_t, 3>>& triangles)
{
  std::map<std::array<std::uint32_t, 2>, int> uses;
  for (const auto& t : triangles)
  {
    for (std::size_t i = 0; i < 3; ++i)
    {
      ++uses[{ t[i], t[(i + 1) % 3] }];
      --uses[{ t[(i + 1) % 3], t[i] }];
    }
  }
  std::map<std::uint32_t, std::uint32_t> next;
  for (const auto& [edge, count] : uses)
  {
    if (count > 0)
    {
      next.emplace(edge[0], edge[1]);
    }
  }
  std::vector<std::uint32_t> loop;
  for (auto at = next.begin(); at != next.end(); at = next.find(loop.back()))
  {
    loop.push_back(at->second);
    next.erase(at);
  }
  return loop;
}

class GapCloser
{
public:
  GapCloser(const SurfaceView& view, const Options& options, Execution& execution)
    : options_(options)
    , execution_(execution)
    , prepared_(joinSurface(view, options, execution))
    , points_(prepared_.surface.lattice, view)
    , parts_(prepared_.surface, execution)
  {
  }

  // Between rims that face each other.
  std::vector<ClosedGap> strips()
  {
    std::vector<ClosedGap> strips;
    forEachRegion([&](Surface& surface, std::int32_t region) {
      surface.region.assign(surface.triangles.size(), region);
      takeBaffles(surface, options_.baffles);
      const double widest = options_.closeGaps / surface.lattice.step();
      std::vector<RimStrip> found = findRimStrips(surface, widest, execution_);
      const auto isNarrow = [&](const RimStrip& strip) {
        return strip.width < smallestBoxAt(strip.rim, surface);
      };
      found.erase(std::remove_if(found.begin(), found.end(), isNarrow), found.end());
      closeEnds(surface, widest, found, execution_);
      for (const RimStrip& strip : found)
      {
        strips.push_back(gapOf(strip.rim, strip.width, surface, region));
        addTriangles(strip.triangles.begin(), strip.triangles.end(), surface, strips.back());
      }
    });
    return strips;
  }

  // `strips`: of the view already; first in the result.
  ClosedGaps close(std::vector<ClosedGap> strips)
  {
    result_.gaps = std::move(strips);
    const std::vector<std::uint8_t>& open = prepared_.openSheets.isOfOne;
    if (!options_.baffles.empty() || !open.empty())
    {
      doubleSheets(prepared_.surface, options_.baffles, open,
        options_.contactTolerance / prepared_.surface.lattice.step(), execution_);
    }
    forEachRegion([&](Surface& surface, std::int32_t region) { closeIn(surface, region); });
    result_.gaps.insert(result_.gaps.end(), betweenParts_.begin(), betweenParts_.end());
    result_.panes = sortedUnique(std::move(result_.panes));
    std::sort(result_.replaced.begin(), result_.replaced.end());
    result_.added = points_.takeAdded();
    return std::move(result_);
  }

private:
  // With a copy of its surface.
  template <class Visitor>
  void forEachRegion(Visitor&& visit) const
  {
    if (prepared_.surface.region.empty())
    {
      Surface all = prepared_.surface;
      visit(all, OutsideRegion);
    }
    const std::set<std::int32_t> regions(
      prepared_.surface.region.begin(), prepared_.surface.region.end());
    for (const std::int32_t region : regions)
    {
      Surface own = ofRegion(prepared_.surface, region);
      visit(own, region);
    }
  }

  void closeIn(Surface& surface, std::int32_t region)
  {
    const Surface given = surface;
    const SurfaceRepair repaired =
      repair(surface, prepared_.planes, repairOf(options_), execution_);
    closeHolesOf(repaired, repaired.crossing ? *repaired.crossing : surface, region);
    closeBetweenParts(
      closePartGaps(given, surface, options_.closeGaps / surface.lattice.step(), execution_),
      region);
  }

  void closeHolesOf(const SurfaceRepair& repaired, const Surface& surface, std::int32_t region)
  {
    for (const Hole& hole : repaired.holes)
    {
      const double width = hole.width * surface.lattice.step();
      if (hole.width < smallestBoxAt(hole.rim, surface) || width > options_.closeGaps)
      {
        continue;
      }
      if (const std::vector<std::uint32_t> pane = parts_.closing(hole.rim); !pane.empty())
      {
        result_.panes.insert(result_.panes.end(), pane.begin(), pane.end());
        continue;
      }
      ClosedGap gap = gapOf(hole.rim, hole.width, surface, region);
      const auto first = surface.triangles.begin() + std::ptrdiff_t(hole.firstTriangle);
      addTriangles(first, first + std::ptrdiff_t(hole.triangles), surface, gap);
      result_.gaps.push_back(std::move(gap));
    }
  }

  // `width`: levels.
  ClosedGap gapOf(const std::vector<std::uint32_t>& rim, double width, const Surface& surface,
    std::int32_t region)
  {
    ClosedGap gap;
    gap.region = region;
    gap.width = width * surface.lattice.step();
    for (const std::uint32_t vertex : rim)
    {
      gap.rim.push_back(points_.at(surface.vertices[vertex]));
    }
    return gap;
  }

  template <class Iterator>
  void addTriangles(Iterator first, Iterator end, const Surface& surface, ClosedGap& gap)
  {
    for (; first != end; ++first)
    {
      const auto& [a, b, c] = *first;
      gap.triangles.push_back(
        points_.at(Corners{ surface.vertices[a], surface.vertices[b], surface.vertices[c] }));
    }
  }

  void closeBetweenParts(const PartGaps& found, std::int32_t region)
  {
    for (const PartGaps::Gap& gap : found.gaps)
    {
      ClosedGap closed;
      closed.region = region;
      closed.width = gap.width * prepared_.surface.lattice.step();
      for (const Corners& strip : gap.strips)
      {
        closed.triangles.push_back(points_.at(strip));
      }
      closed.rim = loopAround(closed.triangles);
      betweenParts_.push_back(std::move(closed));
    }
    for (const PartGaps::Piece& piece : found.pieces)
    {
      result_.pieces.push_back({ piece.given, points_.at(piece.corners) });
    }
    result_.replaced.insert(result_.replaced.end(), found.replaced.begin(), found.replaced.end());
    for (const Vector& place : found.refused)
    {
      result_.refused.push_back(userPlaceOf(place));
    }
  }

  Vector userPlaceOf(const Vector& levels) const
  {
    const Lattice& lattice = prepared_.surface.lattice;
    Vector place = scaled(levels, lattice.step());
    for (std::size_t axis = 0; axis < 3; ++axis)
    {
      place[axis] += lattice.origin()[axis];
    }
    return place;
  }

  // Its shortest side, levels.
  double smallestBoxAt(const std::vector<std::uint32_t>& rim, const Surface& surface) const
  {
    Vector centre{};
    for (const std::uint32_t vertex : rim)
    {
      centre = plus(
        centre, scaled(toVector(surface.vertices[vertex]), 1. / static_cast<double>(rim.size())));
    }
    return std::ldexp(narrowestSide(prepared_.planes, centre), -depthAtSurface(options_));
  }

  const Options& options_;
  Execution& execution_;
  PreparedSurface prepared_;
  Points points_;
  Parts parts_; // before anything is repaired
  std::vector<ClosedGap> betweenParts_;
  ClosedGaps result_;
};

using TrianglesOfPoints = std::vector<std::array<std::uint32_t, 3>>;

// Takes out what is of triangles from `count` on, those of strips; returns the pieces that replace them, by triangle.
std::map<std::uint32_t, TrianglesOfPoints> takeOfStrips(std::size_t count, ClosedGaps& closed)
{
  const auto isGiven = [&](std::uint32_t triangle) { return triangle < count; };
  const auto cut = [&](std::vector<std::uint32_t>& triangles) {
    return std::partition_point(triangles.begin(), triangles.end(), isGiven);
  };
  closed.panes.erase(cut(closed.panes), closed.panes.end());
  std::map<std::uint32_t, TrianglesOfPoints> pieces;
  for (auto triangle = cut(closed.replaced); triangle != closed.replaced.end(); ++triangle)
  {
    pieces[*triangle];
  }
  closed.replaced.erase(cut(closed.replaced), closed.replaced.end());
  std::vector<ClosedGaps::Piece> given;
  for (const ClosedGaps::Piece& piece : closed.pieces)
  {
    if (isGiven(piece.given))
    {
      given.push_back(piece);
    }
    else
    {
      pieces[piece.given].push_back(piece.points);
    }
  }
  closed.pieces = std::move(given);
  return pieces;
}

// The triangles of strips, the first gaps, are those of the view from `count` on.
void replaceInStrips(std::size_t count, ClosedGaps& closed)
{
  const std::map<std::uint32_t, TrianglesOfPoints> pieces = takeOfStrips(count, closed);
  auto triangle = static_cast<std::uint32_t>(count);
  for (auto gap = closed.gaps.begin(); gap != closed.gaps.end() && !pieces.empty(); ++gap)
  {
    TrianglesOfPoints kept;
    for (const auto& points : gap->triangles)
    {
      if (const auto found = pieces.find(triangle++); found == pieces.end())
      {
        kept.push_back(points);
      }
      else
      {
        kept.insert(kept.end(), found->second.begin(), found->second.end());
      }
    }
    gap->triangles = std::move(kept);
  }
}

}

ClosedGaps closedGaps(const SurfaceView& view, const Options& options, Execution& execution)
{
  requireInRange(Options::GapWidths, options.closeGaps, "Close Gaps");
  if (options.closeGaps == 0)
  {
    return {};
  }
  GapCloser closer(view, options, execution);
  std::vector<ClosedGap> strips = closer.strips();
  if (strips.empty())
  {
    return closer.close({});
  }
  const ViewWithGaps whole(view, strips);
  ClosedGaps closed = GapCloser(whole.view(), options, execution).close(std::move(strips));
  replaceInStrips(view.triangleCount, closed);
  return closed;
}

}
