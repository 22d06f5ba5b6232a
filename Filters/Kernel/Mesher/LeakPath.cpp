// SPDX-License-Identifier: BSD-3-Clause
#include "Mesher/LeakPath.h"

#include "Mesher/LeakGaps.h"
#include "Mesher/LeakWay.h"

#include <algorithm>

namespace cartesian
{

namespace
{

// The most points of each search, in turn, and the memory that each point takes.
constexpr std::array<double, 3> Searches{ 3e5, 2.4e6, 2e7 };
constexpr double BytesOfAPoint = 20;

constexpr double WallWeight = 0.1; // of walls, as a part of the distance of the two ends

Vector toLevels(const Vector& place, const Lattice& lattice)
{
  Vector levels;
  for (std::size_t axis = 0; axis < 3; ++axis)
  {
    levels[axis] = (place[axis] - lattice.position(static_cast<int>(axis), 0)) / lattice.step();
  }
  return levels;
}

LeakPath inUserUnits(LeakPath path, const Lattice& lattice)
{
  const auto convert = [&](Vector& at) {
    for (std::size_t axis = 0; axis < 3; ++axis)
    {
      at[axis] = lattice.position(static_cast<int>(axis), 0) + lattice.step() * at[axis];
    }
  };
  std::for_each(path.points.begin(), path.points.end(), convert);
  for (LeakGap& gap : path.gaps)
  {
    std::for_each(gap.across.begin(), gap.across.end(), convert);
    gap.width *= lattice.step();
  }
  return path;
}

std::string describe(const LeakSearch& search, const LeakPath& path)
{
  constexpr std::size_t MostNamed = 5;
  if (!search.from && path.points.empty())
  {
    return search.to->name +
      " lies in a space that is meshed: move or remove it, or give Keep Points in the spaces to be "
      "meshed.";
  }
  const std::size_t gaps = path.gaps.size();
  std::string text = search.to->name + " is reached from " +
    (search.from ? search.from->name : "the sides of the domain box");
  text += gaps == 0 ? "" : " through " + std::to_string(gaps) + (gaps == 1 ? " gap: " : " gaps: ");
  for (std::size_t i = 0; i < std::min(gaps, MostNamed); ++i)
  {
    const LeakGap& gap = path.gaps[i];
    const double unit = gap.width / 1000;
    Vector at = gap.middle();
    std::transform(
      at.begin(), at.end(), at.begin(), [&](double x) { return std::round(x / unit) * unit; });
    text += (i == 0 ? "" : ", ") + number(gap.width) + " wide at (" + number(at[0]) + ", " +
      number(at[1]) + ", " + number(at[2]) + ")";
  }
  text += gaps > MostNamed ? ", ..." : "";
  text += gaps == 0
    ? ". Move or remove one of the points, or add the wall between them."
    : ". Close the gaps, in the surface or by Close Gaps, or move or remove one of the points.";
  return text + (path.points.empty() ? "" : " The output Defects shows the way.");
}

}

LeakSearch::LeakSearch(const Meshlines& planes, Level around, double side, double most)
  : spacing(side / 2)
  , memory(most)
{
  for (std::size_t axis = 0; axis < 3; ++axis)
  {
    low[axis] = planes[axis].front() - around;
    high[axis] = planes[axis].back() + around;
  }
}

double LeakSearch::diagonal() const
{
  return norm(minus(toVector(high), toVector(low)));
}

double LeakSearch::spacingOf(double points) const
{
  double volume = 1;
  for (std::size_t axis = 0; axis < 3; ++axis)
  {
    volume *= double(high[axis]) - low[axis];
  }
  return std::cbrt(volume / points);
}

LeakPath findLeak(const Surface& walls, const LeakSearch& search, Execution& execution)
{
  const WallSearch wallSearch(walls, execution);
  WayEnds ends{ std::nullopt, toLevels(search.to->place, walls.lattice) };
  double across = search.diagonal();
  if (search.from)
  {
    ends.from = toLevels(search.from->place, walls.lattice);
    across = norm(minus(ends.to, *ends.from));
  }
  LeakPath path;
  double spacing = search.spacing;
  for (const double most : Searches)
  {
    if (BytesOfAPoint * most > search.memory)
    {
      break;
    }
    spacing = std::max(spacing, search.spacingOf(most));
    PointGrid grid(search.low, search.high, spacing);
    grid.block(walls, execution);
    path.points = findWay(grid, wallSearch, ends, WallWeight * across, execution);
    if (!path.points.empty())
    {
      path.gaps = gapsAlong(path.points, spacing, search, wallSearch, execution);
      break;
    }
    spacing /= 2;
    execution.reach(most / Searches.back());
  }
  return inUserUnits(std::move(path), walls.lattice);
}

Leak::Leak(const LeakSearch& search, LeakPath way)
  : Error(Fault::BadParameter, describe(search, way))
  , path(std::move(way))
{
}

void tellLeak(const Surface& walls, const LeakSearch& search, Execution& execution)
{
  throw Leak(search, findLeak(walls, search, execution));
}

}
