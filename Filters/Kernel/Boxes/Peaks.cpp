// SPDX-License-Identifier: BSD-3-Clause
#include "Boxes/Peaks.h"

#include "Base/DisjointSets.h"
#include "Base/Sorting.h"

#include <algorithm>
#include <array>
#include <cmath>
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
  bool isFlat;
  bool rises;  // these are on different sides of the vertex
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
      static_cast<std::uint32_t>(t), { a, b }, isFlat, isAbove(a, vertex) != isAbove(b, vertex),
      area };
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

// Triangles around one vertex in one region fall into fans: several where bodies touch. Of a fan that a line along
// which bodies touch cuts open it is not known whether it rises; the line's ends are in fans that close.
class Fans
{
public:
  Fans(Iterator begin, Iterator end)
    : begin_(begin)
    , size_(static_cast<std::size_t>(end - begin))
    , fans_(size_)
  {
    for (std::size_t i = 0; i < size_; ++i)
    {
      for (const std::uint32_t corner : begin_[std::ptrdiff_t(i)].others)
      {
        corners_.push_back({ corner, static_cast<std::uint32_t>(i) });
      }
    }
    std::sort(corners_.begin(), corners_.end());
    forEachCorner([&](std::size_t first, std::size_t last) {
      if (last - first == 2)
      {
        fans_.unite(corners_[first].second, corners_[first + 1].second);
      }
    });
  }

  // Of those that are on no slope.
  WallAreas peaks()
  {
    std::vector<int> rises(size_);
    std::vector<std::uint8_t> isOpen(size_);
    forEachCorner([&](std::size_t first, std::size_t last) {
      for (std::size_t i = first; i < last; ++i)
      {
        const std::uint32_t fan = fans_.find(corners_[i].second);
        isOpen[fan] |= std::count_if(corners_.begin() + std::ptrdiff_t(first),
                         corners_.begin() + std::ptrdiff_t(last),
                         [&](const Corner& c) { return fans_.find(c.second) == fan; }) != 2;
      }
    });
    forEachTriangle([&](std::uint32_t fan, const Around& around) { rises[fan] += around.rises; });
    WallAreas areas;
    forEachTriangle([&](std::uint32_t fan, const Around& around) {
      if (rises[fan] != RisesOfASlope && isOpen[fan] == 0)
      {
        (around.area > 0 ? areas.domainBelow : areas.domainAbove) += std::abs(around.area);
      }
    });
    return areas;
  }

private:
  using Corner = std::pair<std::uint32_t, std::uint32_t>; // and the number of its triangle

  template <class Visitor>
  void forEachCorner(const Visitor& visit) const
  {
    for (std::size_t first = 0; first < corners_.size();)
    {
      std::size_t last = first;
      while (last < corners_.size() && corners_[last].first == corners_[first].first)
      {
        ++last;
      }
      visit(first, last);
      first = last;
    }
  }

  template <class Visitor>
  void forEachTriangle(const Visitor& visit)
  {
    for (std::size_t i = 0; i < size_; ++i)
    {
      visit(fans_.find(static_cast<std::uint32_t>(i)), begin_[std::ptrdiff_t(i)]);
    }
  }

  const Iterator begin_;
  const std::size_t size_;
  DisjointSets fans_;           // of the triangles
  std::vector<Corner> corners_; // in order
};

// Those of one vertex in one region.
void addPeak(Iterator begin, Iterator end, Level level, WallsByLevel& peaks)
{
  const WallAreas areas = Fans(begin, end).peaks();
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
