// SPDX-License-Identifier: BSD-3-Clause
#include "Surface/KeepPoints.h"

#include "Base/Error.h"
#include "Lattice/ExactFit.h"
#include "Surface/LineCrossings.h"

#include <algorithm>
#include <cmath>

namespace cartesian
{

namespace
{

std::string nameOf(const char* list, std::size_t row, const std::array<double, 3>& place)
{
  return "Row " + std::to_string(row) + " of " + list + ", (" + number(place[0]) + ", " +
    number(place[1]) + ", " + number(place[2]) + "),";
}

constexpr const char* KeepPoints = "Keep Points";
constexpr const char* KeepOut = "Keep Out";

void requireFinite(const std::string& name, const std::array<double, 3>& place)
{
  if (!std::all_of(place.begin(), place.end(), [](double x) { return std::isfinite(x); }))
  {
    throw Error(Fault::BadCoordinate, name + " is not a valid point: give three finite numbers.");
  }
}

bool isBeyond(const std::array<double, 3>& place, const Lattice& lattice, const Meshlines& planes)
{
  for (std::size_t axis = 0; axis < 3; ++axis)
  {
    const auto position = [&](Level level) {
      return lattice.position(static_cast<int>(axis), level);
    };
    if (place[axis] < position(planes[axis].front()) ||
      place[axis] >= position(planes[axis].back()))
    {
      return true;
    }
  }
  return false;
}

void requireWithin(const std::string& name, const std::array<double, 3>& place,
  const Lattice& lattice, const Meshlines& planes)
{
  for (std::size_t axis = 0; axis < 3; ++axis)
  {
    const double low = lattice.position(static_cast<int>(axis), planes[axis].front());
    const double high = lattice.position(static_cast<int>(axis), planes[axis].back());
    if (place[axis] < low || place[axis] >= high)
    {
      throw Error(Fault::BadParameter,
        name + " lies outside the grid, which runs from " + number(low) + " to " + number(high) +
          " along " + "xyz"[axis] + ": move it into the space to be meshed.");
    }
  }
}

Point pointAt(const std::array<double, 3>& place, const Lattice& lattice)
{
  Point at;
  for (std::size_t axis = 0; axis < 3; ++axis)
  {
    at[axis] = lattice.vertex(static_cast<int>(axis), place[axis]) - 1;
  }
  return at;
}

// Around the point, and whether the surface comes next to it.
void look(const Surface& surface, KeepPoint& point)
{
  constexpr Level Next = 2;
  const Point& low = point.at;
  const Point high{ low[0] + Next, low[1] + Next, low[2] + Next };
  point.winding = surface.around;
  for (std::size_t t = 0; t < surface.triangles.size(); ++t)
  {
    const Corners corners = surface.corners(t);
    forEachLineCrossing(corners, RowsAlong[0], { low[1] }, { low[2] },
      [&](std::size_t, std::size_t, const Point& p, bool up) {
        if (p[0] < low[0])
        {
          point.winding.add(surface.crossing(t, up));
        }
      });
    if (clip(corners, low, high).size > 0)
    {
      throw Error(
        Fault::BadParameter, point.name + " lies on the surface: move it away from there.");
    }
  }
}

}

std::vector<KeepPoint> onLattice(
  const std::vector<std::array<double, 3>>& places, const Surface& surface, const Meshlines& planes)
{
  const std::vector<Point> at = placesOnLattice(places, surface.lattice, planes);
  std::vector<KeepPoint> points;
  points.reserve(places.size());
  for (const std::array<double, 3>& place : places)
  {
    KeepPoint point{ at[points.size()], {}, nameOf(KeepPoints, points.size(), place), place };
    look(surface, point);
    points.push_back(std::move(point));
  }
  return points;
}

std::vector<KeepPoint> keepOutOnLattice(
  const std::vector<std::array<double, 3>>& places, const Surface& surface, const Meshlines& planes)
{
  std::vector<KeepPoint> points;
  for (const std::array<double, 3>& place : places)
  {
    KeepPoint point{ {}, {}, nameOf(KeepOut, points.size(), place), place };
    requireFinite(point.name, place);
    point.isBeyond = isBeyond(place, surface.lattice, planes);
    if (!point.isBeyond)
    {
      point.at = pointAt(place, surface.lattice);
      look(surface, point);
    }
    points.push_back(std::move(point));
  }
  return points;
}

std::vector<Point> placesOnLattice(
  const std::vector<std::array<double, 3>>& places, const Lattice& lattice, const Meshlines& planes)
{
  std::vector<Point> points;
  points.reserve(places.size());
  for (const std::array<double, 3>& place : places)
  {
    const std::string name = nameOf(KeepPoints, points.size(), place);
    requireFinite(name, place);
    requireWithin(name, place, lattice, planes);
    points.push_back(pointAt(place, lattice));
  }
  return points;
}

void requireInside(const std::vector<KeepPoint>& points, const char* domain)
{
  for (const KeepPoint& point : points)
  {
    if (!point.winding.inside())
    {
      throw Error(Fault::BadParameter,
        point.name + " lies outside the space that Domain " + domain +
          " meshes: move it, or set Domain to Around Points.");
    }
  }
}

bool areOutside(const std::vector<KeepPoint>& points)
{
  if (points.empty())
  {
    throw Error(Fault::BadParameter,
      "Domain is Around Points, but there are no Keep Points: give one in each space to be "
      "meshed.");
  }
  const bool isOutside = !points[0].winding.inside();
  for (const KeepPoint& point : points)
  {
    if (point.winding.inside() == isOutside)
    {
      const std::string& in = isOutside ? point.name : points[0].name;
      const std::string& out = isOutside ? points[0].name : point.name;
      throw Error(Fault::BadParameter,
        in + " lies inside a body and " + out +
          " outside all bodies: one mesh has cells on one side of the surface only. Remove one of "
          "the two.");
    }
  }
  return isOutside;
}

}
