// SPDX-License-Identifier: BSD-3-Clause
#include "Boxes/PlanesAside.h"

#include "Base/Sorting.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <numeric>

namespace cartesian
{

namespace
{

constexpr std::size_t TrianglesAChunk = 4096;

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

// Corners this near to the first or the last plane, as a part of the surface's longest side, were meant to lie on it:
// the noise of coordinates where a surface was cut by hand, and half the thickness that a sheet gets.
constexpr double EndTolerance = 4e-6;

// Walls that run along a plane of the fine grid.
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

// The corners of the oriented triangles for which is(corners), in order.
template <class Predicate>
std::vector<Corners> trianglesThatAre(
  const Surface& surface, Execution& execution, const Predicate& is)
{
  const std::size_t count = surface.triangles.size();
  std::vector<std::vector<Corners>> parts(chunks(count, TrianglesAChunk));
  execution.forEach(count, TrianglesAChunk, [&](std::size_t begin, std::size_t end) {
    for (std::size_t t = begin; t < end; ++t)
    {
      const Corners c = surface.corners(t);
      const bool oriented = surface.byParity.empty() || surface.byParity[t] == 0;
      if (oriented && is(c))
      {
        parts[begin / TrianglesAChunk].push_back(c);
      }
    }
  });
  return concatenated(parts);
}

FlatWalls flatWalls(const Surface& surface, std::size_t axis, Execution& execution)
{
  FlatWalls walls;
  for (const Corners& c : trianglesThatAre(surface, execution, [&](const Corners& corners) {
         return corners[1][axis] == corners[0][axis] && corners[2][axis] == corners[0][axis];
       }))
  {
    const double area = projectedArea(c, axis);
    WallAreas& ofLevel = walls[c[0][axis]];
    (area > 0 ? ofLevel.domainBelow : ofLevel.domainAbove) += std::abs(area);
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
    const double most = std::max(1.0, LargestStep * spacing / double(planes.partsPerBox()));
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

// The level of a corner as seen from one end of the grid: 0 on the plane there, more towards the middle.
class SeenFromEnd
{
public:
  SeenFromEnd(const Surface& surface, const std::vector<Level>& lines, std::size_t axis, bool upper)
    : surface_(surface)
    , axis_(axis)
    , plane_(upper ? lines.back() : lines.front())
    , sign_(upper ? -1 : 1)
  {
  }

  double height(const Point& p) const { return sign_ * (double(p[axis_]) - plane_); }

  // Twice the area of walls all of whose corners are within a distance of the plane: of those with the domain between
  // them and the plane, less that of the others.
  double wallsWithin(double distance, Execution& execution) const
  {
    const std::vector<Corners> near = trianglesThatAre(surface_, execution, [&](const Corners& c) {
      return std::all_of(
        c.begin(), c.end(), [&](const Point& p) { return std::abs(height(p)) <= distance; });
    });
    return std::accumulate(near.begin(), near.end(), 0.0,
      [&](double sum, const Corners& c) { return sum + sign_ * projectedArea(c, axis_); });
  }

  // Of the highest corner that no gap of this size separates from the plane; 0: there is none.
  double top(double gap, Execution& execution) const
  {
    const std::size_t count = surface_.triangles.size();
    std::vector<std::vector<double>> parts(chunks(count, TrianglesAChunk));
    execution.forEach(count, TrianglesAChunk, [&](std::size_t begin, std::size_t end) {
      for (std::size_t t = begin; t < end; ++t)
      {
        for (const std::uint32_t vertex : surface_.triangles[t])
        {
          const double h = height(surface_.vertices[vertex]);
          if (h > 0 && h <= MostGaps * gap)
          {
            parts[begin / TrianglesAChunk].push_back(h);
          }
        }
      }
    });
    std::vector<double> heights = concatenated(parts);
    std::sort(heights.begin(), heights.end());
    double highest = 0;
    for (const double h : heights)
    {
      highest = h <= highest + gap ? h : highest;
    }
    return highest;
  }

private:
  static constexpr double MostGaps = 4;

  const Surface& surface_;
  const std::size_t axis_;
  const Level plane_;
  const double sign_;
};

// Past corners that were meant to lie on the plane: else a film of the domain stays between, whose walls, or what is
// left where it is removed, lie across the end. Not past a wall with the domain on its other side, which ends it there.
void endPastCorners(
  const Surface& surface, Meshlines& planes, std::size_t axis, double near, Execution& execution)
{
  std::vector<Level>& lines = planes[axis];
  const double most = LargestStep * (double(lines[1]) - lines[0]) / double(planes.partsPerBox());
  const double gap = std::min(near, most);
  for (const bool upper : { false, true })
  {
    const SeenFromEnd end(surface, lines, axis, upper);
    const double top = end.top(gap, execution);
    if (top > 0 && end.wallsWithin(top, execution) >= 0)
    {
      const auto step = static_cast<Level>(top + 1); // corners are on odd levels
      (upper ? lines.back() : lines.front()) += upper ? Level(0) - step : step;
    }
  }
}

double longestSide(const Surface& surface, Execution& execution)
{
  struct Range
  {
    Point low{ ~Level(0), ~Level(0), ~Level(0) };
    Point high{};
  };
  const std::size_t count = surface.triangles.size();
  std::vector<Range> ranges(chunks(count, TrianglesAChunk));
  execution.forEach(count, TrianglesAChunk, [&](std::size_t begin, std::size_t end) {
    Range& range = ranges[begin / TrianglesAChunk];
    for (std::size_t t = begin; t < end; ++t)
    {
      for (const Point& p : surface.corners(t))
      {
        for (std::size_t axis = 0; axis < 3; ++axis)
        {
          range.low[axis] = std::min(range.low[axis], p[axis]);
          range.high[axis] = std::max(range.high[axis], p[axis]);
        }
      }
    }
  });
  double longest = 0;
  for (std::size_t axis = 0; axis < 3; ++axis)
  {
    Level low = ~Level(0);
    Level high = 0;
    for (const Range& range : ranges)
    {
      low = std::min(low, range.low[axis]);
      high = std::max(high, range.high[axis]);
    }
    longest = std::max(longest, double(high) - low);
  }
  return longest;
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
  const std::int64_t step = FinePerBox / planes.partsPerBox();
  for (const WallsAlong& along : wallsAlong(walls, planes, axis, rounding, planes.partsPerBox()))
  {
    const Level plane = planeAt(planes, axis, along.fine);
    const Level best = bestPlane(along.walls, plane);
    if (best != plane && best > planeAt(planes, axis, along.fine - step) &&
      best < planeAt(planes, axis, along.fine + step))
    {
      planes.moved[axis].push_back({ along.fine, best });
    }
  }
}

}

void stepAside(const Surface& surface, int depth, Meshlines& planes, Execution& execution)
{
  planes.planeLevel = std::clamp(depth, LeastPlaneLevel, DeepestLevel);
  const double longest = surface.around.inside() ? longestSide(surface, execution) : 0;
  for (std::size_t axis = 0; axis < 3; ++axis)
  {
    const FlatWalls walls = flatWalls(surface, axis, execution);
    const double rounding = roundingOf(surface, planes, axis);
    stepMeshlines(walls, planes, axis, rounding);
    if (surface.around.inside())
    {
      endInWalls(planes[axis], walls);
      endPastCorners(surface, planes, axis, EndTolerance * longest, execution);
    }
    stepPlanesBetween(walls, planes, axis, rounding);
  }
}

}
