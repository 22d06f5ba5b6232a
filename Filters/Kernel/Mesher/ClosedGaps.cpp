// SPDX-License-Identifier: BSD-3-Clause
#include "Mesher/ClosedGaps.h"

#include "Base/DisjointSets.h"
#include "Mesher/Mesher.h"
#include "Mesher/ViewWithGaps.h"
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

// A point of the view at each vertex that triangles use.
std::vector<std::uint32_t> pointsAt(const Surface& surface, const SurfaceView& view)
{
  std::map<Point, std::uint32_t> first;
  for (std::size_t corner = 0; corner < 3 * view.triangleCount; ++corner)
  {
    const std::uint32_t p = view.triangles[corner];
    Point place;
    for (int axis = 0; axis < 3; ++axis)
    {
      place[static_cast<std::size_t>(axis)] =
        surface.lattice.vertex(axis, view.points[3 * std::size_t(p) + std::size_t(axis)]);
    }
    std::uint32_t& lowest = first.emplace(place, p).first->second;
    lowest = std::min(lowest, p);
  }
  std::vector<std::uint32_t> points;
  points.reserve(surface.vertices.size());
  for (const Point& vertex : surface.vertices)
  {
    const auto found = first.find(vertex);
    points.push_back(found != first.end() ? found->second : 0);
  }
  return points;
}

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

class GapCloser
{
public:
  GapCloser(const SurfaceView& view, const Options& options, Execution& execution)
    : options_(options)
    , execution_(execution)
    , prepared_(joinSurface(view, options, execution))
    , points_(pointsAt(prepared_.surface, view))
    , parts_(prepared_.surface, execution)
  {
  }

  // Between rims that face each other.
  std::vector<ClosedGap> strips() const
  {
    std::vector<ClosedGap> strips;
    forEachRegion([&](Surface& surface, std::int32_t region) {
      surface.region.assign(surface.triangles.size(), region);
      takeBaffles(surface, options_.baffles);
      const double step = surface.lattice.step();
      const double widest = options_.closeGaps / step;
      std::vector<RimStrip> found = findRimStrips(surface, widest, execution_);
      const auto isNarrow = [&](const RimStrip& strip) {
        return strip.width < smallestBoxAt(strip.rim, surface);
      };
      found.erase(std::remove_if(found.begin(), found.end(), isNarrow), found.end());
      closeEnds(surface, widest, found, execution_);
      for (const RimStrip& strip : found)
      {
        strips.push_back(gapOf(strip.rim, region, strip.width * step));
        addTriangles(strip.triangles, strips.back());
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
    std::sort(result_.panes.begin(), result_.panes.end());
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
    const SurfaceRepair repaired =
      closeAndOrient(surface, prepared_.planes, repairOf(options_), execution_);
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
      ClosedGap gap = gapOf(hole.rim, region, width);
      const auto first = surface.triangles.begin() + std::ptrdiff_t(hole.firstTriangle);
      addTriangles({ first, first + std::ptrdiff_t(hole.triangles) }, gap);
      result_.gaps.push_back(std::move(gap));
    }
  }

  ClosedGap gapOf(const std::vector<std::uint32_t>& rim, std::int32_t region, double width) const
  {
    ClosedGap gap;
    gap.region = region;
    gap.width = width;
    for (const std::uint32_t vertex : rim)
    {
      gap.rim.push_back(points_[vertex]);
    }
    return gap;
  }

  void addTriangles(
    const std::vector<std::array<std::uint32_t, 3>>& triangles, ClosedGap& gap) const
  {
    for (const auto& [a, b, c] : triangles)
    {
      gap.triangles.push_back({ points_[a], points_[b], points_[c] });
    }
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
  std::vector<std::uint32_t> points_; // of the view, at vertices
  Parts parts_;                       // before anything is repaired
  ClosedGaps result_;
};

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
  const auto given = [&](std::uint32_t triangle) { return triangle < view.triangleCount; };
  closed.panes.erase(
    std::partition_point(closed.panes.begin(), closed.panes.end(), given), closed.panes.end());
  return closed;
}

}
