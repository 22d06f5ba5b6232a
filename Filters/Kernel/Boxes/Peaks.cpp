// SPDX-License-Identifier: BSD-3-Clause
#include "Boxes/Peaks.h"

#include "Base/Sorting.h"

#include <algorithm>
#include <cmath>
#include <tuple>

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
  bool isFlat;
  bool rises;  // its other corners are on different sides of the vertex
  double area; // positive: the region is below; 0: it is steep

  bool operator<(const Around& other) const
  {
    return std::tie(vertex, region, triangle) <
      std::tie(other.vertex, other.region, other.triangle);
  }
};

class PeakSearch
{
public:
  PeakSearch(const Surface& surface, std::size_t axis, const std::vector<std::uint8_t>& isNear)
    : surface_(surface)
    , axis_(axis)
    , isNear_(isNear)
  {
  }

  // Of the triangles begin to end - 1.
  void addTo(std::vector<Around>& list, std::size_t begin, std::size_t end) const
  {
    for (std::size_t t = begin; t < end; ++t)
    {
      const bool isOriented = surface_.byParity.empty() || surface_.byParity[t] == 0;
      for (std::size_t i = 0; i < 3 && isOriented; ++i)
      {
        if (isNear_[surface_.triangles[t][i]] != 0)
        {
          add(t, i, list);
        }
      }
    }
  }

private:
  void add(std::size_t t, std::size_t i, std::vector<Around>& list) const
  {
    const auto& triangle = surface_.triangles[t];
    const std::uint32_t vertex = triangle[i];
    const std::uint32_t a = triangle[(i + 1) % 3];
    const std::uint32_t b = triangle[(i + 2) % 3];
    const double area = tangentArea(surface_.corners(t));
    const bool isFlat = height(a) == height(vertex) && height(b) == height(vertex);
    Around around{ vertex, surface_.walls.behind(surface_.boundary[t]),
      static_cast<std::uint32_t>(t), isFlat, isAbove(a, vertex) != isAbove(b, vertex), area };
    list.push_back(around);
    if (surface_.walls.isInterface(surface_.boundary[t]))
    {
      around.region = surface_.walls.front(surface_.boundary[t]);
      around.area = -area;
      list.push_back(around);
    }
  }

  double tangentArea(const Corners& c) const
  {
    const double along = projectedArea(c, axis_);
    const double across =
      std::hypot(projectedArea(c, (axis_ + 1) % 3), projectedArea(c, (axis_ + 2) % 3));
    return across <= SteepestTangent * std::abs(along) ? along : 0;
  }

  Level height(std::uint32_t vertex) const { return surface_.vertices[vertex][axis_]; }

  // Of vertices at one level the later one counts as the higher one.
  bool isAbove(std::uint32_t a, std::uint32_t b) const
  {
    return std::tuple(height(a), a) > std::tuple(height(b), b);
  }

  const Surface& surface_;
  const std::size_t axis_;
  const std::vector<std::uint8_t>& isNear_;
};

// Around a vertex on a slope, what is above meets what is below twice.
constexpr int RisesOfASlope = 2;

using Iterator = std::vector<Around>::const_iterator;

// Those of one vertex in one region.
void addPeak(Iterator begin, Iterator end, Level level, WallsByLevel& peaks)
{
  if (std::count_if(begin, end, [](const Around& a) { return a.rises; }) == RisesOfASlope)
  {
    return;
  }
  WallAreas areas;
  std::for_each(begin, end, [&](const Around& a) {
    (a.area > 0 ? areas.domainBelow : areas.domainAbove) += std::abs(a.area);
  });
  if (areas.all() > 0)
  {
    WallAreas& ofLevel = peaks[level];
    ofLevel.domainBelow += areas.domainBelow;
    ofLevel.domainAbove += areas.domainAbove;
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
  const PeakSearch search(surface, axis, isNear);
  const std::size_t count = surface.triangles.size();
  std::vector<std::vector<Around>> parts(chunks(count, TrianglesAChunk));
  execution.forEach(count, TrianglesAChunk, [&](std::size_t begin, std::size_t end) {
    search.addTo(parts[begin / TrianglesAChunk], begin, end);
  });
  std::vector<Around> list = concatenated(parts);
  std::sort(list.begin(), list.end());

  WallsByLevel peaks;
  for (auto vertex = list.cbegin(); vertex != list.cend();)
  {
    const auto next = std::find_if(
      vertex, list.cend(), [&](const Around& a) { return a.vertex != vertex->vertex; });
    const bool isFlat = std::any_of(vertex, next, [](const Around& a) { return a.isFlat; });
    for (auto begin = vertex; begin != next && !isFlat;)
    {
      const auto end =
        std::find_if(begin, next, [&](const Around& a) { return a.region != begin->region; });
      addPeak(begin, end, surface.vertices[vertex->vertex][axis], peaks);
      begin = end;
    }
    vertex = next;
  }
  return peaks;
}

}
