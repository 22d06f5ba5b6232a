// SPDX-License-Identifier: BSD-3-Clause
#include "Repair/DomainBox.h"

#include "Repair/OpenPieces.h"
#include "Repair/OpenRims.h"

#include <algorithm>
#include <cmath>
#include <map>

namespace cartesian
{

namespace
{

// How far the sides are beyond the planes, as a part of the grid's longest side: much more than files round.
constexpr double Beyond = 1.0 / 256;

// How far a way around the surface may lead, as another such part.
constexpr double Around = 1.0 / 4;

// Terrain covers at least this part of the box's cross section.
constexpr double LeastCover = 0.5;

double longestOf(const Meshlines& planes)
{
  double longest = 0;
  for (const std::vector<Level>& lines : planes)
  {
    longest = std::max(longest, double(lines.back()) - lines.front());
  }
  return longest;
}

Bounds grown(Bounds grid, double room)
{
  for (std::size_t axis = 0; axis < 3; ++axis)
  {
    grid.low[axis] -= room;
    grid.high[axis] += room;
  }
  return grid;
}

class Sides
{
public:
  // `butAcross`: nothing is near the sides across this axis.
  Sides(const Meshlines& planes, double near, std::size_t butAcross = NoAxis)
    : butAcross_(butAcross)
  {
    const Level beyond = oddLevel(Beyond * longestOf(planes)); // planes are on even levels
    for (std::size_t axis = 0; axis < 3; ++axis)
    {
      level_[2 * axis] = planes[axis].front() - beyond;
      level_[2 * axis + 1] = planes[axis].back() + beyond;
    }
    near_ = near + beyond;
  }

  Level of(std::size_t side) const { return level_[side]; }

  // How far inside a side.
  double inside(std::size_t side, const Point& p) const
  {
    const double way = double(p[side / 2]) - level_[side];
    return side % 2 == 0 ? way : -way;
  }

  bool isReached(std::size_t side, const Point& p) const
  {
    return side / 2 != butAcross_ && inside(side, p) <= near_;
  }

  bool isNear(std::size_t side, const Point& p) const
  {
    return inside(side, p) > 0 && isReached(side, p);
  }

  // Where a corner of a rim is continued to.
  Point goalOf(Point p) const
  {
    const Point given = p;
    for (std::size_t side = 0; side < level_.size(); ++side)
    {
      p[side / 2] = isNear(side, given) ? level_[side] : p[side / 2];
    }
    return p;
  }

  bool areNearOne(const Point& p, const Point& q) const
  {
    bool are = false;
    for (std::size_t side = 0; side < level_.size(); ++side)
    {
      are = are || (isReached(side, p) && isReached(side, q));
    }
    return are;
  }

  // Of the cross section, levels squared.
  double areaAcross(std::size_t axis) const
  {
    double area = 1;
    for (std::size_t other = 0; other < 3; ++other)
    {
      area *= other == axis ? 1 : double(level_[2 * other + 1]) - level_[2 * other];
    }
    return area;
  }

private:
  std::size_t butAcross_;
  double near_; // inside a side
  std::array<Level, 6> level_{};
};

// As a vector, levels squared.
Vector areaOf(const Surface& surface, const OpenPiece& piece)
{
  Vector twice{};
  for (const std::uint32_t t : piece.triangles)
  {
    const Corners c = surface.corners(t);
    twice = plus(twice, cross(minus(c[1], c[0]), minus(c[2], c[0])));
  }
  return scaled(twice, 0.5);
}

bool reachesAround(
  const Surface& surface, const OpenPiece& piece, const Sides& sides, std::size_t axis)
{
  std::array<bool, 6> isReached{};
  const auto reachesAny = [&](std::uint32_t v) {
    bool any = false;
    for (std::size_t side = 0; side < isReached.size(); ++side)
    {
      const bool is = sides.isReached(side, surface.vertices[v]);
      isReached[side] = isReached[side] || is;
      any = any || is;
    }
    return any;
  };
  const bool all = std::all_of(piece.rim.begin(), piece.rim.end(),
    [&](const auto& edge) { return reachesAny(edge[0]) && reachesAny(edge[1]); });
  const std::size_t one = (axis + 1) % 3;
  const std::size_t other = (axis + 2) % 3;
  return all && isReached[2 * one] && isReached[2 * one + 1] && isReached[2 * other] &&
    isReached[2 * other + 1];
}

}

Bounds withRoom(Bounds grid)
{
  return grown(grid, 2 * Beyond * grid.longest());
}

Level roomAround(const Meshlines& planes)
{
  return oddLevel(Around * longestOf(planes));
}

Bounds withRoomAround(Bounds grid)
{
  return grown(grid, 2 * Around * grid.longest());
}

std::vector<Terrain> findTerrain(
  const Surface& surface, const Meshlines& planes, double near, Execution& execution)
{
  const Sides sides(planes, near);
  std::vector<Terrain> found;
  for (const OpenPiece& piece : openPiecesOf(surface, {}, execution))
  {
    const Vector area = areaOf(surface, piece);
    for (std::size_t axis = 0; axis < 3; ++axis)
    {
      if (std::abs(area[axis]) >= LeastCover * sides.areaAcross(axis) &&
        reachesAround(surface, piece, sides, axis))
      {
        found.push_back({ piece.triangles.front(), axis, area[axis] > 0, piece.triangles });
        break;
      }
    }
  }
  return found;
}

void continueToSides(Surface& surface, const Meshlines& planes, double near,
  const std::vector<std::uint32_t>& triangles, std::size_t butAcross, Execution& execution)
{
  const Sides sides(planes, near, butAcross);
  std::map<Point, std::uint32_t> made;
  const auto goalOf = [&](std::uint32_t v) {
    const Point goal = sides.goalOf(surface.vertices[v]);
    if (goal == surface.vertices[v])
    {
      return v;
    }
    const auto [at, isNew] =
      made.emplace(goal, static_cast<std::uint32_t>(surface.vertices.size()));
    if (isNew)
    {
      surface.vertices.push_back(goal);
    }
    return at->second;
  };
  const auto add = [&](std::uint32_t a, std::uint32_t b, std::uint32_t c, std::uint32_t like) {
    if (a != b && b != c && c != a)
    {
      surface.triangles.push_back({ a, b, c });
      surface.boundary.push_back(surface.boundary[like]);
    }
  };
  for (const OpenEdge& edge : openEdgesOf(surface, execution))
  {
    if (!std::binary_search(triangles.begin(), triangles.end(), edge.triangle) ||
      !sides.areNearOne(surface.vertices[edge.lower], surface.vertices[edge.upper]))
    {
      continue;
    }
    const auto& c = surface.triangles[edge.triangle];
    const auto at = std::find(c.begin(), c.end(), edge.lower) - c.begin();
    const bool isUp = c[static_cast<std::size_t>(at + 1) % 3] == edge.upper;
    const std::uint32_t from = isUp ? edge.upper : edge.lower;
    const std::uint32_t to = isUp ? edge.lower : edge.upper;
    const std::uint32_t fromGoal = goalOf(from);
    const std::uint32_t toGoal = goalOf(to);
    add(from, to, toGoal, edge.triangle);
    add(from, toGoal, fromGoal, edge.triangle);
  }
}

std::size_t addSides(Surface& surface, const Meshlines& planes)
{
  const Sides sides(planes, 0);
  const std::size_t first = surface.triangles.size();
  const auto start = static_cast<std::uint32_t>(surface.vertices.size());
  for (std::size_t corner = 0; corner < 8; ++corner)
  {
    surface.vertices.push_back({ sides.of(corner & 1U), sides.of(2 + ((corner >> 1U) & 1U)),
      sides.of(4 + ((corner >> 2U) & 1U)) });
  }
  for (std::size_t side = 0; side < 6; ++side)
  {
    const std::size_t axis = side / 2;
    const std::uint32_t a = 1U << ((axis + 1) % 3);
    const std::uint32_t b = 1U << ((axis + 2) % 3);
    const std::uint32_t low = start + (side % 2 == 0 ? 0 : 1U << axis);
    const std::array<std::uint32_t, 4> up{ low, low + a, low + a + b, low + b };
    const bool isUp = side % 2 == 1;
    surface.triangles.push_back({ up[0], isUp ? up[1] : up[2], isUp ? up[2] : up[1] });
    surface.triangles.push_back({ up[0], isUp ? up[2] : up[3], isUp ? up[3] : up[2] });
    surface.boundary.insert(surface.boundary.end(), 2, NoBoundary);
  }
  return first;
}

}
