// SPDX-License-Identifier: BSD-3-Clause
#include "Boxes/PlanesAside.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>

namespace cartesian
{

namespace
{

// A wall farther from a plane than this part of the way to the next one that may divide boxes does not run
// along it.
constexpr double LargestStep = 1.0 / 16;

// Of walls perpendicular to an axis, at one level; in square levels.
struct WallAreas
{
  double domainBelow = 0;
  double domainAbove = 0;
};

using FlatWalls = std::map<Level, WallAreas>;

// Walls that run along a plane, which is so many smallest parts of boxes from the first meshline.
struct WallsAlong
{
  std::int64_t fine;
  FlatWalls walls;
};

// Twice the area along the axis: positive where the normal points up.
double projectedArea(const Corners& c, std::size_t axis)
{
  const std::size_t u = (axis + 1) % 3;
  const std::size_t v = (axis + 2) % 3;
  const auto along = [&](std::size_t corner, std::size_t w) {
    return static_cast<double>(c[corner][w]) - static_cast<double>(c[0][w]);
  };
  return along(1, u) * along(2, v) - along(1, v) * along(2, u);
}

FlatWalls flatWalls(const Surface& surface, std::size_t axis)
{
  FlatWalls walls;
  for (std::size_t t = 0; t < surface.triangles.size(); ++t)
  {
    const Corners c = surface.corners(t);
    const Level level = c[0][axis];
    const bool oriented = surface.byParity.empty() || surface.byParity[t] == 0;
    if (oriented && c[1][axis] == level && c[2][axis] == level)
    {
      const double area = projectedArea(c, axis);
      (area > 0 ? walls[level].domainBelow : walls[level].domainAbove) += std::abs(area);
    }
  }
  return walls;
}

// How far off single precision may put the coordinates of walls and of the first meshline, in levels.
double roundingOf(const Surface& surface, const Meshlines& planes, std::size_t axis)
{
  const auto sizeAt = [&](Level level) {
    return std::abs(surface.lattice.position(static_cast<int>(axis), level));
  };
  const double largest = std::max(sizeAt(planes[axis].front()), sizeAt(planes[axis].back()));
  return std::max(
    1.0, largest * double(std::numeric_limits<float>::epsilon()) / surface.lattice.step());
}

// By plane, in order: of those that divide the space between two meshlines into `parts`, the meshlines among them
// only if `parts` is 1.
std::vector<WallsAlong> wallsAlong(const FlatWalls& walls, const Meshlines& planes,
  std::size_t axis, double rounding, std::int64_t parts)
{
  const std::vector<Level>& lines = planes[axis];
  std::vector<WallsAlong> result;
  for (const auto& [level, areas] : walls)
  {
    if (level < lines.front() || level > lines.back())
    {
      continue;
    }
    const auto i = static_cast<std::size_t>(intervalOf(lines, level));
    const double spacing = double(lines[i + 1]) - lines[i];
    const std::int64_t part = std::lround((double(level) - lines[i]) / spacing * double(parts));
    const std::int64_t fine = (std::int64_t(i) * parts + part) * (FinePerBox / parts);
    const double distance = std::abs(double(planeAt(planes, axis, fine)) - level);
    const double most = std::max(1.0, LargestStep * spacing / double(FinePerBox));
    if (distance > std::min(rounding, most) || (parts > 1 && fine % FinePerBox == 0))
    {
      continue;
    }
    if (result.empty() || result.back().fine != fine)
    {
      result.push_back({ fine, {} });
    }
    result.back().walls.insert({ level, areas });
  }
  return result;
}

// The area of walls that would have a flange.
double flangesOf(const FlatWalls& walls, Level plane)
{
  double sum = 0;
  for (const auto& [level, areas] : walls)
  {
    sum += plane < level ? areas.domainBelow : areas.domainAbove;
  }
  return sum;
}

// Where the plane does best, as near as possible.
Level bestPlane(const FlatWalls& walls, Level plane)
{
  Level best = plane;
  const auto distance = [&](Level level) { return std::abs(double(level) - plane); };
  const auto tryOut = [&](Level level) {
    const double change = flangesOf(walls, level) - flangesOf(walls, best);
    if (change < 0 || (change == 0 && distance(level) < distance(best)))
    {
      best = level;
    }
  };
  for (const auto& [level, areas] : walls)
  {
    tryOut(level - 1);
    tryOut(level + 1);
  }
  return best;
}

// The domain beyond the first and the last plane is cut off: there is no flange on the other side.
void endInWalls(std::vector<Level>& lines, const FlatWalls& walls)
{
  const auto first = walls.find(lines.front() + 1);
  if (first != walls.end() && first->second.domainBelow > 0 && lines.front() + 2 < lines[1])
  {
    lines.front() += 2;
  }
  const auto last = walls.find(lines.back() - 1);
  if (last != walls.end() && last->second.domainAbove > 0 &&
    lines.back() - 2 > lines[lines.size() - 2])
  {
    lines.back() -= 2;
  }
}

void stepMeshlines(const FlatWalls& walls, Meshlines& planes, std::size_t axis, double rounding)
{
  std::vector<Level>& lines = planes[axis];
  for (const WallsAlong& along : wallsAlong(walls, planes, axis, rounding, 1))
  {
    const auto i = static_cast<std::size_t>(along.fine / FinePerBox);
    if (i > 0 && i + 1 < lines.size())
    {
      const Level best = bestPlane(along.walls, lines[i]);
      if (best > lines[i - 1] && best < lines[i + 1])
      {
        lines[i] = best;
      }
    }
  }
}

void stepPlanesBetween(const FlatWalls& walls, Meshlines& planes, std::size_t axis, double rounding)
{
  for (const WallsAlong& along : wallsAlong(walls, planes, axis, rounding, FinePerBox))
  {
    const Level plane = planeAt(planes, axis, along.fine);
    const Level best = bestPlane(along.walls, plane);
    if (best != plane && best > planeAt(planes, axis, along.fine - 1) &&
      best < planeAt(planes, axis, along.fine + 1))
    {
      planes.moved[axis].push_back({ along.fine, best });
    }
  }
}

}

void stepAside(const Surface& surface, Meshlines& planes)
{
  for (std::size_t axis = 0; axis < 3; ++axis)
  {
    const FlatWalls walls = flatWalls(surface, axis);
    const double rounding = roundingOf(surface, planes, axis);
    stepMeshlines(walls, planes, axis, rounding);
    if (surface.around.inside())
    {
      endInWalls(planes[axis], walls);
    }
    stepPlanesBetween(walls, planes, axis, rounding);
  }
}

}
