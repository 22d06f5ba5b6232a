// SPDX-License-Identifier: BSD-3-Clause
#include "Mesher/ExpectedDepths.h"

#include "Boxes/PlanePerturbation.h"
#include "Mesher/Mesher.h"

#include <algorithm>
#include <cmath>

namespace cartesian
{

namespace
{

// If the surface passes through more global boxes than these, it takes seconds to find them.
constexpr double MostLookedAt = 2e6;

// What is curved or narrow is found in a repaired surface, which takes longer.
constexpr std::size_t MostRepaired = 100000; // triangles

constexpr std::size_t Grain = 4096; // places

using Index = std::array<std::uint32_t, 3>;

struct Place
{
  Index global;                     // the global box that it is in
  std::array<std::int64_t, 3> fine; // where in that box
  std::size_t number;
};

using Places = std::vector<Place>::iterator;

Place placeOf(const std::array<double, 3>& point, std::size_t number, const Lattice& lattice,
  const Meshlines& planes)
{
  Place place{ {}, {}, number };
  for (std::size_t axis = 0; axis < 3; ++axis)
  {
    const std::vector<Level>& lines = planes[axis];
    const Level level = lattice.vertex(static_cast<int>(axis), point[axis]);
    const std::int64_t last = static_cast<std::int64_t>(lines.size()) - 2;
    const auto i =
      static_cast<std::size_t>(std::clamp<std::int64_t>(intervalOf(lines, level), 0, last));
    const double part = (double(level) - lines[i]) / (double(lines[i + 1]) - lines[i]);
    place.global[axis] = static_cast<std::uint32_t>(i);
    place.fine[axis] = std::clamp<std::int64_t>(
      static_cast<std::int64_t>(part * double(FinePerBox)), 0, FinePerBox - 1);
  }
  return place;
}

// Depths in global boxes of which some parts must be deeper than others.
class DepthsInParts
{
public:
  explicit DepthsInParts(std::vector<std::uint8_t>& depths)
    : depths_(depths)
  {
  }

  void look(const Forcing& forcing, const Cube& cube, Places begin, Places end)
  {
    if (forcing.regions.empty() && forcing.octants.first == forcing.octants.second)
    {
      raise(begin, end, forcing.least);
      return;
    }
    if (cube.level == DeepestLevel)
    {
      return;
    }
    const Cube first = cube.part(1, 0);
    const auto unitOf = [&](const Place& place) {
      std::size_t unit = 0;
      for (std::size_t axis = 0; axis < 3; ++axis)
      {
        unit |= std::size_t(place.fine[axis] - cube.offset[axis] >= first.size()) << axis;
      }
      return unit;
    };
    std::sort(begin, end, [&](const Place& a, const Place& b) { return unitOf(a) < unitOf(b); });
    Refinement::forcedOfUnits(forcing, begin->global, cube, 1, scratch_, forced_);
    struct Part
    {
      Forcing forcing;
      Cube cube;
      Places begin;
      Places end;
    };
    std::vector<Part> deeper;
    while (begin != end)
    {
      const std::size_t unit = unitOf(*begin);
      const auto next =
        std::find_if(begin, end, [&](const Place& place) { return unitOf(place) != unit; });
      if (forced_[unit] > first.level)
      {
        deeper.push_back({ Refinement::forcingOfUnit(forcing, cube, 1, unit, scratch_),
          cube.part(1, unit), begin, next });
      }
      raise(begin, next, std::min<int>(forced_[unit], first.level));
      begin = next;
    }
    for (const Part& part : deeper)
    {
      look(part.forcing, part.cube, part.begin, part.end);
    }
  }

private:
  void raise(Places begin, Places end, int depth)
  {
    for (; begin != end; ++begin)
    {
      std::uint8_t& own = depths_[begin->number];
      own = std::max(own, static_cast<std::uint8_t>(depth));
    }
  }

  std::vector<std::uint8_t>& depths_;
  ForcingScratch scratch_;
  std::vector<std::uint8_t> forced_;
};

std::vector<std::uint8_t> depthsOf(
  const std::vector<Place>& places, const Refinement& refinement, Execution& execution)
{
  std::vector<std::uint8_t> depths(places.size());
  std::vector<std::uint8_t> inPart(places.size());
  execution.forEach(places.size(), Grain, [&](std::size_t begin, std::size_t end) {
    for (std::size_t t = begin; t < end; ++t)
    {
      const Index& at = places[t].global;
      const Depths own = refinement.at(at[0], at[1], at[2]);
      depths[t] = static_cast<std::uint8_t>(own.allowed);
      inPart[t] = own.inPart() ? 1 : 0;
    }
  });
  std::vector<Place> some;
  std::copy_if(places.begin(), places.end(), std::back_inserter(some),
    [&](const Place& place) { return inPart[place.number] != 0; });
  std::sort(
    some.begin(), some.end(), [](const Place& a, const Place& b) { return a.global < b.global; });
  DepthsInParts parts(depths);
  for (auto begin = some.begin(); begin != some.end();)
  {
    execution.poll();
    const Index global = begin->global;
    const auto end =
      std::find_if(begin, some.end(), [&](const Place& place) { return place.global != global; });
    const Depths own = refinement.at(global[0], global[1], global[2]);
    parts.look(refinement.forcingOf(global, own), {}, begin, end);
    begin = end;
  }
  return depths;
}

Bounds endsOf(const Meshlines& planes, const Lattice& lattice)
{
  Bounds ends{};
  for (int axis = 0; axis < 3; ++axis)
  {
    const auto a = static_cast<std::size_t>(axis);
    ends.low[a] = lattice.position(axis, planes[a].front());
    ends.high[a] = lattice.position(axis, planes[a].back());
  }
  return ends;
}

// The longest edge of a global box, in user units.
double longestEdge(const Index& global, const Meshlines& planes, const Lattice& lattice)
{
  double longest = 0;
  for (std::size_t axis = 0; axis < 3; ++axis)
  {
    const std::vector<Level>& lines = planes[axis];
    longest = std::max(longest, double(lines[global[axis] + 1]) - lines[global[axis]]);
  }
  return longest * lattice.step();
}

// As prepareSurface(), if the surface is oriented outwards.
PreparedSurface prepareQuickly(
  const SurfaceView& view, const Options& options, Execution& execution)
{
  PreparedSurface prepared = placeOnGrid(view, options, execution);
  if (options.domain.isOutside())
  {
    turnInsideOut(prepared.surface);
  }
  stepAside(prepared.surface, refinementOf(options).deepest(), prepared.planes, execution);
  return prepared;
}

}

bool hasSeveralDepths(const Options& options)
{
  const RefinementSpec spec = refinementOf(options);
  return !spec.blocks.empty() || !spec.boundaries.empty() || !spec.regions.empty() ||
    spec.sizing.any();
}

ExpectedDepths expectedDepths(const SurfaceView& view, const Options& options,
  const std::vector<std::array<double, 3>>& given, Execution& execution)
{
  const RefinementSpec spec = refinementOf(options, boundsOf(view).longest());
  const bool isRepaired = spec.sizing.any() && view.triangleCount <= MostRepaired;
  const PreparedSurface prepared = isRepaired ? prepareSurface(view, options, execution)
                                              : prepareQuickly(view, options, execution);
  const Surface& surface = prepared.surface;
  const Meshlines& planes = prepared.planes;
  ExpectedDepths result{ endsOf(planes, surface.lattice), {}, {} };
  if ((spec.sizing.any() && !isRepaired) ||
    estimateMesh(surface, planes).intersected > MostLookedAt)
  {
    return result;
  }
  const Shoeboxes shoeboxes = fillShoeboxes(surface, planes, execution);
  const Refinement refinement(spec, surface, shoeboxes, planes, execution);
  std::vector<Place> places(given.size());
  execution.forEach(places.size(), Grain, [&](std::size_t begin, std::size_t end) {
    for (std::size_t i = begin; i < end; ++i)
    {
      places[i] = placeOf(given[i], i, surface.lattice, planes);
    }
  });
  result.depths = depthsOf(places, refinement, execution);
  result.sizes.resize(places.size());
  for (std::size_t i = 0; i < places.size(); ++i)
  {
    result.sizes[i] =
      std::ldexp(longestEdge(places[i].global, planes, surface.lattice), -result.depths[i]);
  }
  return result;
}

}
