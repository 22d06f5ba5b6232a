// SPDX-License-Identifier: BSD-3-Clause
#include "Sections/FoldedPolygons.h"

#include <algorithm>
#include <set>

namespace cartesian
{

namespace
{

bool cross(const PlanePlace& a, const PlanePlace& b, const PlanePlace& c, const PlanePlace& d)
{
  return (turnOf(a, b, c) > 0) != (turnOf(a, b, d) > 0) &&
    (turnOf(c, d, a) > 0) != (turnOf(c, d, b) > 0);
}

class Unfolding
{
public:
  explicit Unfolding(PlanePolygons& polygons)
    : polygons_(polygons)
  {
  }

  std::vector<std::uint32_t> run()
  {
    std::vector<std::uint32_t> folded = foldedOf();
    if (!folded.empty())
    {
      listNeighbours();
    }
    for (bool any = true; any && !folded.empty(); folded = foldedOf())
    {
      any = false;
      for (const std::uint32_t polygon : folded)
      {
        any = (isFolded(polygon) && movePointsOf(polygon)) || any;
      }
    }
    return { moved_.begin(), moved_.end() };
  }

private:
  const PlanePlace& corner(std::size_t polygon, std::size_t i) const
  {
    return polygons_.points[polygons_.corner(polygon, i)];
  }

  bool isFolded(std::size_t p) const
  {
    const std::size_t size = polygons_.size(p);
    double area = 0;
    for (std::size_t i = 1; i + 1 < size; ++i)
    {
      area += turnOf(corner(p, 0), corner(p, i), corner(p, i + 1));
    }
    bool result = area <= 0;
    for (std::size_t i = 0; i < size && !result; ++i)
    {
      // Not those that have a corner in common.
      for (std::size_t j = i + 2; j + (i == 0 ? 1 : 0) < size && !result; ++j)
      {
        result = cross(corner(p, i), corner(p, i + 1), corner(p, j), corner(p, j + 1));
      }
    }
    return result;
  }

  std::vector<std::uint32_t> foldedOf() const
  {
    std::vector<std::uint32_t> folded;
    for (std::uint32_t p = 0; p < polygons_.count(); ++p)
    {
      if (isFolded(p))
      {
        folded.push_back(p);
      }
    }
    return folded;
  }

  void listNeighbours()
  {
    neighbours_.resize(polygons_.points.size());
    polygonsAt_.resize(polygons_.points.size());
    isOutline_.resize(polygons_.points.size());
    for (std::uint32_t p = 0; p < polygons_.count(); ++p)
    {
      for (std::size_t i = 0; i < polygons_.size(p); ++i)
      {
        polygonsAt_[polygons_.corner(p, i)].push_back(p);
      }
    }
    for (const PlaneEdge& edge : edgesOf(polygons_))
    {
      neighbours_[edge.from].push_back(edge.to);
      neighbours_[edge.to].push_back(edge.from);
      if (edge.isOutline())
      {
        isOutline_[edge.from] = isOutline_[edge.to] = true;
      }
    }
  }

  std::size_t foldedAt(std::uint32_t point) const
  {
    const std::vector<std::uint32_t>& around = polygonsAt_[point];
    return static_cast<std::size_t>(
      std::count_if(around.begin(), around.end(), [&](std::uint32_t p) { return isFolded(p); }));
  }

  PlanePlace meanAround(std::uint32_t point) const
  {
    PlanePlace sum{};
    for (const std::uint32_t other : neighbours_[point])
    {
      const PlanePlace& at = polygons_.points[other];
      sum = { sum[0] + at[0], sum[1] + at[1] };
    }
    const auto count = static_cast<double>(neighbours_[point].size());
    return { sum[0] / count, sum[1] / count };
  }

  // The least part of the way that leaves fewer folded ones; none: it stays.
  bool tryToMove(std::uint32_t point)
  {
    const PlanePlace from = polygons_.points[point];
    const PlanePlace mean = meanAround(point);
    const std::size_t before = foldedAt(point);
    for (int part = 1; part <= FoldedPolygons::Parts; ++part)
    {
      polygons_.points[point] = between(from, mean, double(part) / FoldedPolygons::Parts);
      if (foldedAt(point) < before)
      {
        moved_.insert(point);
        return true;
      }
    }
    polygons_.points[point] = from;
    return false;
  }

  bool movePointsOf(std::uint32_t polygon)
  {
    for (std::size_t i = 0; i < polygons_.size(polygon); ++i)
    {
      const std::uint32_t point = polygons_.corner(polygon, i);
      if (!isOutline_[point] && tryToMove(point))
      {
        return true;
      }
    }
    return false;
  }

  PlanePolygons& polygons_;
  std::vector<std::vector<std::uint32_t>> neighbours_; // of each point
  std::vector<std::vector<std::uint32_t>> polygonsAt_;
  std::vector<bool> isOutline_;
  std::set<std::uint32_t> moved_;
};

}

std::vector<std::uint32_t> unfold(PlanePolygons& polygons)
{
  return Unfolding(polygons).run();
}

}
