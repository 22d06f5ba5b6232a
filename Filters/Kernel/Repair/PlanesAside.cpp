// SPDX-License-Identifier: BSD-3-Clause
#include "Repair/PlanesAside.h"

#include <algorithm>
#include <cmath>
#include <map>

namespace cartesian
{

namespace
{

// Of walls perpendicular to an axis, one level above or below a plane; in square levels.
struct WallAreas
{
  double domainBelow = 0;
  double domainAbove = 0;
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

bool isPlane(const std::vector<Level>& planes, Level level)
{
  return std::binary_search(planes.begin(), planes.end(), level);
}

// By level, of walls next to a plane.
std::map<Level, WallAreas> wallsNextTo(
  const std::vector<Level>& planes, const Surface& surface, std::size_t axis)
{
  std::map<Level, WallAreas> walls;
  for (std::size_t t = 0; t < surface.triangles.size(); ++t)
  {
    const Corners c = surface.corners(t);
    const Level level = c[0][axis];
    const bool oriented = surface.byParity.empty() || surface.byParity[t] == 0;
    if (oriented && c[1][axis] == level && c[2][axis] == level &&
      (isPlane(planes, level - 1) || isPlane(planes, level + 1)))
    {
      const double area = projectedArea(c, axis);
      (area > 0 ? walls[level].domainBelow : walls[level].domainAbove) += std::abs(area);
    }
  }
  return walls;
}

// The domain beyond the first and the last plane is cut off: there is no flange on the other side.
void endInWalls(std::vector<Level>& planes, const std::map<Level, WallAreas>& walls)
{
  const auto first = walls.find(planes.front() + 1);
  if (first != walls.end() && first->second.domainBelow > 0 && planes.front() + 2 < planes[1])
  {
    planes.front() += 2;
  }
  const auto last = walls.find(planes.back() - 1);
  if (last != walls.end() && last->second.domainAbove > 0 &&
    planes.back() - 2 > planes[planes.size() - 2])
  {
    planes.back() -= 2;
  }
}

}

void stepAside(const Surface& surface, Meshlines& planes)
{
  for (std::size_t axis = 0; axis < 3; ++axis)
  {
    const std::map<Level, WallAreas> walls = wallsNextTo(planes[axis], surface, axis);
    const auto at = [&](Level level) {
      const auto found = walls.find(level);
      return found == walls.end() ? WallAreas() : found->second;
    };
    for (std::size_t i = 1; !walls.empty() && i + 1 < planes[axis].size(); ++i)
    {
      Level& plane = planes[axis][i];
      const WallAreas above = at(plane + 1);
      const WallAreas below = at(plane - 1);
      const double stay = above.domainBelow + below.domainAbove;
      const double up = above.domainAbove + below.domainAbove;
      const double down = below.domainBelow + above.domainBelow;
      if (up < std::min(stay, down) && plane + 2 < planes[axis][i + 1])
      {
        plane += 2;
      }
      else if (down < stay && plane - 2 > planes[axis][i - 1])
      {
        plane -= 2;
      }
    }
    if (surface.around.inside())
    {
      endInWalls(planes[axis], walls);
    }
  }
}

}
