// SPDX-License-Identifier: BSD-3-Clause
#include "Boxes/Peaks.h"

#include "Base/DisjointSets.h"
#include "Base/Rings.h"
#include "Base/Sorting.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <tuple>
#include <utility>

namespace cartesian
{

namespace
{

constexpr std::size_t TrianglesAChunk = 4096;

// Steeper walls are not tangent to a plane that touches them: the ledge there is hardly wider than high.
constexpr double SteepestTangent = 0.5;

// A triangle around a vertex, seen from one of its regions.
struct Around
{
  std::uint32_t vertex;
  std::int32_t region;
  std::uint32_t triangle;
  std::array<std::uint32_t, 2> others; // its other corners
  Vector normal;                       // out of the region, twice the area long

  bool operator<(const Around& other) const
  {
    return std::tie(vertex, region, triangle) <
      std::tie(other.vertex, other.region, other.triangle);
  }
};

using Iterator = std::vector<Around>::const_iterator;

// The surface as a landscape, with heights along an axis.
class Heights
{
public:
  Heights(const Surface& surface, std::size_t axis)
    : surface_(surface)
    , axis_(axis)
  {
  }

  Level of(std::uint32_t vertex) const { return surface_.vertices[vertex][axis_]; }

  bool isFlat(const Around& around) const
  {
    return of(around.others[0]) == of(around.vertex) && of(around.others[1]) == of(around.vertex);
  }

  bool isTangent(const Around& around) const
  {
    const double across =
      std::hypot(around.normal[(axis_ + 1) % 3], around.normal[(axis_ + 2) % 3]);
    return across <= SteepestTangent * std::abs(area(around));
  }

  // Along the axis; positive: the region is below.
  double area(const Around& around) const { return around.normal[axis_]; }

  // Whether the walls around a vertex rise on one side and fall on the other: what is above meets what is below twice.
  bool areOnASlope(Iterator begin, Iterator end) const
  {
    return std::count_if(begin, end, [&](const Around& a) {
      return isAbove(a.others[0], a.vertex) != isAbove(a.others[1], a.vertex);
    }) == 2;
  }

  // Whether all walls around a vertex rise from it; or whether all fall.
  bool allAre(bool rising, Iterator begin, Iterator end) const
  {
    return std::all_of(begin, end, [&](const Around& a) {
      return std::all_of(a.others.begin(), a.others.end(),
        [&](std::uint32_t other) { return isAbove(other, a.vertex) == rising; });
    });
  }

private:
  // Of vertices at one level the later one counts as the higher one.
  bool isAbove(std::uint32_t a, std::uint32_t b) const
  {
    return std::tuple(of(a), a) > std::tuple(of(b), b);
  }

  const Surface& surface_;
  const std::size_t axis_;
};

// Triangles around one vertex in one region fall into fans: several where the region touches itself.
class Fans
{
public:
  Fans(Iterator begin, Iterator end)
    : begin_(begin)
    , size_(static_cast<std::uint32_t>(end - begin))
    , fans_(size_)
  {
    std::vector<std::pair<std::uint32_t, std::uint32_t>> corners; // and the triangle
    for (std::uint32_t i = 0; i < size_; ++i)
    {
      corners.emplace_back(triangle(i).others[0], i);
      corners.emplace_back(triangle(i).others[1], i);
    }
    std::sort(corners.begin(), corners.end());
    for (std::size_t first = 0, last = 0; first < corners.size(); first = last)
    {
      while (last < corners.size() && corners[last].first == corners[first].first)
      {
        ++last;
      }
      if (last - first == 2)
      {
        fans_.unite(corners[first].second, corners[first + 1].second);
      }
    }
  }

  bool areOne()
  {
    std::uint32_t i = 0;
    while (i < size_ && fans_.find(i) == 0)
    {
      ++i;
    }
    return i == size_;
  }

  // Whether the region is within each of the fans: outward normals point away from its triangles. Else it is between
  // them.
  bool holdRegion(const Surface& surface)
  {
    std::vector<Vector> normal(size_);
    std::vector<Vector> towards(size_);
    for (std::uint32_t i = 0; i < size_; ++i)
    {
      const std::uint32_t fan = fans_.find(i);
      const Around& around = triangle(i);
      normal[fan] = plus(normal[fan], around.normal);
      for (const std::uint32_t corner : around.others)
      {
        const Vector edge = minus(surface.vertices[corner], surface.vertices[around.vertex]);
        towards[fan] = plus(towards[fan], edge);
      }
    }
    std::uint32_t i = 0;
    while (i < size_ && (fans_.find(i) != i || dot(normal[i], towards[i]) < 0))
    {
      ++i;
    }
    return i == size_;
  }

private:
  const Around& triangle(std::uint32_t i) const { return begin_[std::ptrdiff_t(i)]; }

  const Iterator begin_;
  const std::uint32_t size_;
  DisjointSets fans_;
};

// Those around one vertex in one region.
WallAreas areasOfPeak(Iterator begin, Iterator end, const Heights& heights, const Surface& surface)
{
  Fans fans(begin, end);
  const bool touches = !fans.areOne();
  WallAreas areas;
  if (touches ? !fans.holdRegion(surface) : heights.areOnASlope(begin, end))
  {
    return areas;
  }
  const bool isTop = !touches && heights.allAre(false, begin, end);
  const bool isBottom = !touches && heights.allAre(true, begin, end);
  for (auto around = begin; around != end; ++around)
  {
    const double area = heights.area(*around);
    if (!touches && !heights.isTangent(*around))
    {
      continue;
    }
    if (area > 0)
    {
      (isBottom ? areas.around : areas.domainBelow) += area;
    }
    else
    {
      (isTop ? areas.around : areas.domainAbove) -= area;
    }
  }
  return areas;
}

// Around vertices for which `isNear` is 1; in order. Not of sheets: beside a plane that both sides of a sheet are nearer to
// than points of patches may be, both would move to the same place (BoxSurface.h), and cancel.
std::vector<Around> trianglesAround(
  const Surface& surface, const std::vector<std::uint8_t>& isNear, Execution& execution)
{
  const std::size_t count = surface.triangles.size();
  std::vector<std::vector<Around>> parts(chunks(count, TrianglesAChunk));
  execution.forEach(count, TrianglesAChunk, [&](std::size_t begin, std::size_t end) {
    std::vector<Around>& list = parts[begin / TrianglesAChunk];
    for (std::size_t t = begin; t < end; ++t)
    {
      const auto& corners = surface.triangles[t];
      const bool counts =
        (surface.byParity.empty() || surface.byParity[t] == 0) && !surface.isOfSheet(t);
      for (std::size_t i = 0; i < 3 && counts; ++i)
      {
        if (isNear[corners[i]] == 0)
        {
          continue;
        }
        const Corners c = surface.corners(t);
        const Vector normal{ projectedArea(c, 0), projectedArea(c, 1), projectedArea(c, 2) };
        const std::int32_t wall = surface.boundary[t];
        const std::array<std::uint32_t, 2> others = { following(corners, i),
          preceding(corners, i) };
        const auto number = static_cast<std::uint32_t>(t);
        list.push_back({ corners[i], surface.walls.behind(wall), number, others, normal });
        if (surface.walls.isInterface(wall))
        {
          list.push_back(
            { corners[i], surface.walls.front(wall), number, others, scaled(normal, -1) });
        }
      }
    }
  });
  std::vector<Around> all = concatenated(parts);
  std::sort(all.begin(), all.end());
  return all;
}

// Rims of sheets along a level, as walls as wide as they are long: a plane a few levels to the side of the sheet would cut a
// film off it, whose two sides are nearer to the plane than points of patches may be; on the other side it leaves it whole.
void addRimsOfSheets(const Surface& surface, const Heights& heights,
  const std::vector<std::uint8_t>& isNear, WallsByLevel& peaks)
{
  struct Beside
  {
    bool below = false;
    bool above = false;
  };
  std::map<std::array<std::uint32_t, 2>, Beside> rims;
  for (std::size_t t = 0; t < surface.ofSheet.size(); ++t)
  {
    const auto& c = surface.triangles[t];
    for (std::size_t i = 0; i < 3 && surface.ofSheet[t] != 0; ++i)
    {
      const std::uint32_t from = c[i];
      const std::uint32_t to = following(c, i);
      if (isNear[from] != 0 && heights.of(from) == heights.of(to))
      {
        const Level third = heights.of(preceding(c, i));
        Beside& beside = rims[{ std::min(from, to), std::max(from, to) }];
        beside.below = beside.below || third <= heights.of(from);
        beside.above = beside.above || third >= heights.of(from);
      }
    }
  }
  for (const auto& [edge, beside] : rims)
  {
    if (beside.below != beside.above)
    {
      const double length = norm(minus(surface.vertices[edge[1]], surface.vertices[edge[0]]));
      WallAreas& ofLevel = peaks[heights.of(edge[0])];
      (beside.above ? ofLevel.domainAbove : ofLevel.domainBelow) += length * length;
    }
  }
}

}

double projectedArea(const Corners& c, std::size_t axis)
{
  const std::size_t u = (axis + 1) % 3;
  const std::size_t v = (axis + 2) % 3;
  const auto along = [&](std::size_t corner, std::size_t w) {
    return static_cast<double>(c[corner][w]) - static_cast<double>(c[0][w]);
  };
  return along(1, u) * along(2, v) - along(1, v) * along(2, u);
}

WallsByLevel peaksAmong(const Surface& surface, std::size_t axis,
  const std::vector<std::uint8_t>& isNear, Execution& execution)
{
  const std::vector<Around> list = trianglesAround(surface, isNear, execution);
  const Heights heights(surface, axis);
  WallsByLevel peaks;
  for (auto vertex = list.begin(); vertex != list.end();)
  {
    const auto next =
      std::find_if(vertex, list.end(), [&](const Around& a) { return a.vertex != vertex->vertex; });
    const bool isFlat =
      std::any_of(vertex, next, [&](const Around& a) { return heights.isFlat(a); });
    for (auto begin = vertex; begin != next && !isFlat;)
    {
      const auto end =
        std::find_if(begin, next, [&](const Around& a) { return a.region != begin->region; });
      const WallAreas areas = areasOfPeak(begin, end, heights, surface);
      if (areas.all() > 0)
      {
        WallAreas& ofLevel = peaks[heights.of(vertex->vertex)];
        ofLevel.domainBelow += areas.domainBelow;
        ofLevel.domainAbove += areas.domainAbove;
        ofLevel.around += areas.around;
      }
      begin = end;
    }
    vertex = next;
  }
  addRimsOfSheets(surface, heights, isNear, peaks);
  return peaks;
}

}
