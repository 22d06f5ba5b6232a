// SPDX-License-Identifier: BSD-3-Clause
#include "Boxes/PlanePerturbation.h"

#include "Base/Sorting.h"
#include "Boxes/Peaks.h"
#include "Boxes/PlaneClearance.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>
#include <tuple>

namespace cartesian
{

namespace
{

constexpr std::size_t TrianglesAChunk = 4096;

// A wall farther from a plane than this part of the way to the next one that may divide boxes does not run
// along it.
constexpr double LargestStep = 1.0 / 16;

// No peak makes a plane move farther, in clearances of points from planes (PlaneClearance.h).
constexpr double MostClearances = 2;

// Corners this near to the first or the last plane, as a part of the surface's longest side, were meant to lie on it:
// the noise of coordinates where a surface was cut by hand, and half the thickness that a sheet gets.
constexpr double EndTolerance = 4e-6;

// Walls that run along a plane of the fine grid.
struct WallsAlong
{
  std::int64_t fine;
  WallsByLevel walls;
};

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

WallsByLevel flatWalls(const Surface& surface, std::size_t axis, Execution& execution)
{
  WallsByLevel walls;
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
std::vector<WallsAlong> wallsAlong(const WallsByLevel& walls, const Meshlines& planes,
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
double flangesOf(const WallsByLevel& walls, Level plane)
{
  double sum = 0;
  for (const auto& [level, areas] : walls)
  {
    sum += plane < level ? areas.domainBelow : areas.domainAbove;
  }
  return sum;
}

// Where the plane does best, as near as possible.
Level bestPlane(const WallsByLevel& walls, Level plane)
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
void endInWalls(std::vector<Level>& lines, const WallsByLevel& walls)
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

// How far a plane keeps away from peaks, in levels, an odd number. Moving planes may make clearances a step larger.
Level awayFromPeaks(
  const Meshlines& planes, std::size_t axis, std::int64_t fine, const PlaneClearance& clearance)
{
  const auto i = static_cast<std::uint32_t>(
    std::min<std::int64_t>(fine / FinePerBox, std::int64_t(planes[axis].size()) - 2));
  const bool isMeshline = fine % FinePerBox == 0 && i > 0;
  return std::max(clearance.of(axis, i), isMeshline ? clearance.of(axis, i - 1) : 0) + 2;
}

// What planes across an axis go aside for.
struct WallsAcross
{
  WallsByLevel flat;
  WallsByLevel peaks;
};

// The plane that is nearest to a level, of those that divide the space between two meshlines into `parts`.
std::int64_t nearestPlane(
  const Meshlines& planes, std::size_t axis, Level level, std::int64_t parts)
{
  const auto i = static_cast<std::size_t>(intervalOf(planes[axis], level));
  const double part =
    (double(level) - planes[axis][i]) / (double(planes[axis][i + 1]) - planes[axis][i]);
  return std::int64_t(i) * FinePerBox + std::lround(part * double(parts)) * (FinePerBox / parts);
}

bool isWithin(const std::vector<Level>& lines, Level level)
{
  return level >= lines.front() && level < lines.back();
}

// Peaks that planes might come near to, or move to.
WallsByLevel peaksNearPlanes(const Surface& surface, const Meshlines& planes, std::size_t axis,
  const PlaneClearance& clearance, Execution& execution)
{
  std::vector<std::uint8_t> isNear(surface.vertices.size());
  execution.forEach(isNear.size(), TrianglesAChunk, [&](std::size_t begin, std::size_t end) {
    for (std::size_t v = begin; v < end; ++v)
    {
      const Level level = surface.vertices[v][axis];
      if (isWithin(planes[axis], level))
      {
        const std::int64_t fine = nearestPlane(planes, axis, level, planes.partsPerBox());
        const double distance = std::abs(double(planeAt(planes, axis, fine)) - level);
        isNear[v] = distance <= 2 * MostClearances * awayFromPeaks(planes, axis, fine, clearance);
      }
    }
  });
  return peaksAmong(surface, axis, isNear, execution);
}

WallsByLevel within(const WallsByLevel& walls, Level plane, double distance)
{
  const auto first =
    walls.lower_bound(static_cast<Level>(std::max(0.0, std::ceil(double(plane) - distance))));
  return { first, std::find_if(first, walls.end(), [&](const WallsByLevel::value_type& wall) {
            return double(wall.first) > double(plane) + distance;
          }) };
}

// Where no peak is as near, else as few as possible; of these where the plane leaves the smallest area of walls with a
// flange or a cap, as near as possible.
Level planeOffPeaks(const WallsAcross& walls, Level plane, Level away)
{
  const double most = MostClearances * away;
  const auto distance = [](Level a, Level b) { return std::abs(double(a) - b); };
  const WallsByLevel flat = within(walls.flat, plane, 2 * most);
  const WallsByLevel peaks = within(walls.peaks, plane, 2 * most);
  const auto areaAt = [&](Level at) {
    return std::accumulate(
      peaks.begin(), peaks.end(), 0.0, [&](double sum, const WallsByLevel::value_type& peak) {
        return sum + (distance(peak.first, at) < away ? peak.second.all() : 0);
      });
  };
  if (areaAt(plane) == 0)
  {
    return plane;
  }
  const auto harm = [&](Level at) {
    return std::tuple(
      areaAt(at) + flangesOf(flat, at), flangesOf(peaks, at), distance(at, plane), at);
  };
  Level best = plane;
  for (const auto& [level, areas] : peaks)
  {
    for (const Level at : { level - away, level + away })
    {
      best = distance(at, plane) <= most && harm(at) < harm(best) ? at : best;
    }
  }
  return best;
}

void stepMeshlines(const WallsByLevel& walls, Meshlines& planes, std::size_t axis, double rounding)
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

void stepPlanesBetween(
  const WallsByLevel& walls, Meshlines& planes, std::size_t axis, double rounding)
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

void move(Meshlines& planes, std::size_t axis, std::int64_t fine, Level to)
{
  if (fine % FinePerBox == 0)
  {
    planes[axis][static_cast<std::size_t>(fine / FinePerBox)] = to;
    return;
  }
  std::vector<MovedPlane>& moved = planes.moved[axis];
  const auto at = std::lower_bound(moved.begin(), moved.end(), fine,
    [](const MovedPlane& plane, std::int64_t place) { return plane.fine < place; });
  if (at != moved.end() && at->fine == fine)
  {
    at->level = to;
  }
  else
  {
    moved.insert(at, { fine, to });
  }
}

// Of the planes that divide the space between two meshlines into `parts`: the meshlines only if it is 1.
void keepOffPeaks(const WallsAcross& walls, const PlaneClearance& clearance, Meshlines& planes,
  std::size_t axis, std::int64_t parts)
{
  const std::int64_t step = FinePerBox / parts;
  const std::int64_t last = std::int64_t(planes[axis].size() - 1) * FinePerBox;
  std::int64_t before = 0;
  for (const auto& [level, areas] : walls.peaks)
  {
    const std::int64_t fine =
      isWithin(planes[axis], level) ? nearestPlane(planes, axis, level, parts) : before;
    if (fine == before || fine == last || (parts > 1 && fine % FinePerBox == 0))
    {
      continue;
    }
    before = fine;
    const Level plane = planeAt(planes, axis, fine);
    const Level best = planeOffPeaks(walls, plane, awayFromPeaks(planes, axis, fine, clearance));
    if (best != plane && best > planeAt(planes, axis, fine - step) &&
      best < planeAt(planes, axis, fine + step))
    {
      move(planes, axis, fine, best);
    }
  }
}

}

void stepAside(const Surface& surface, int depth, Meshlines& planes, Execution& execution)
{
  planes.planeLevel = std::clamp(depth, LeastPlaneLevel, DeepestLevel);
  const double longest = surface.around.inside() ? longestSide(surface, execution) : 0;
  const Meshlines given = planes;
  const PlaneClearance clearance(surface, given);
  for (std::size_t axis = 0; axis < 3; ++axis)
  {
    const double rounding = roundingOf(surface, planes, axis);
    const WallsAcross walls{ flatWalls(surface, axis, execution),
      peaksNearPlanes(surface, planes, axis, clearance, execution) };
    stepMeshlines(walls.flat, planes, axis, rounding);
    keepOffPeaks(walls, clearance, planes, axis, 1);
    if (surface.around.inside())
    {
      endInWalls(planes[axis], walls.flat);
      endPastCorners(surface, planes, axis, EndTolerance * longest, execution);
    }
    stepPlanesBetween(walls.flat, planes, axis, rounding);
    keepOffPeaks(walls, clearance, planes, axis, planes.partsPerBox());
  }
}

}
