// SPDX-License-Identifier: BSD-3-Clause
#include "Mesher/LeakWay.h"

#include <algorithm>
#include <limits>
#include <queue>

namespace cartesian
{

namespace
{

class LeakFinder
{
public:
  LeakFinder(const PointGrid& grid, const WallSearch& walls, const WayEnds& ends, double weight,
    Execution& execution)
    : grid_(grid)
    , walls_(walls)
    , from_(ends.from)
    , to_(ends.to)
    , weight_(weight)
    , execution_(execution)
    , length_(grid.size(), std::numeric_limits<float>::infinity())
    , clearance_(grid.size(), -1)
    , before_(grid.size(), None)
  {
  }

  std::vector<Vector> run()
  {
    start();
    const std::array<std::size_t, 8> ends = grid_.pointsAround(to_);
    while (!queue_.empty())
    {
      execution_.poll();
      const float length = queue_.top().first;
      const std::size_t point = queue_.top().second;
      queue_.pop();
      if (length > length_[point])
      {
        continue;
      }
      const bool isEnd = std::find(ends.begin(), ends.end(), point) != ends.end();
      if (isEnd && (grid_.isAtEnd(point) || !walls_.areBetween(grid_.placeOf(point), to_)))
      {
        return wayTo(point);
      }
      grid_.forEachNeighbour(point, [&](std::size_t next) {
        const double step = norm(minus(grid_.placeOf(next), grid_.placeOf(point)));
        const double cost = (costAt(point) + costAt(next)) / 2;
        reach(next, { static_cast<float>(length + step * cost), point });
      });
    }
    return {};
  }

private:
  static constexpr std::size_t None = ~std::size_t(0);

  void start()
  {
    if (from_)
    {
      for (const std::size_t point : grid_.pointsAround(*from_))
      {
        const Vector at = grid_.placeOf(point);
        if (!walls_.areBetween(*from_, at))
        {
          reach(point, { static_cast<float>(norm(minus(at, *from_))), None });
        }
      }
      return;
    }
    for (std::size_t point = 0; point < grid_.size(); ++point)
    {
      if (grid_.isAtEnd(point))
      {
        reach(point, { 0, None });
      }
    }
  }

  struct Way
  {
    float length;
    std::size_t before; // the last point of it
  };

  void reach(std::size_t point, const Way& way)
  {
    if (way.length < length_[point])
    {
      length_[point] = way.length;
      before_[point] = way.before;
      queue_.push({ way.length, point });
    }
  }

  double costAt(std::size_t point)
  {
    if (clearance_[point] < 0)
    {
      clearance_[point] = static_cast<float>(walls_.distanceTo(grid_.placeOf(point)));
    }
    return 1 + weight_ / std::max(1.0F, clearance_[point]);
  }

  std::vector<Vector> wayTo(std::size_t point) const
  {
    std::vector<std::size_t> points{ point };
    while (before_[points.back()] != None)
    {
      points.push_back(before_[points.back()]);
    }
    std::reverse(points.begin(), points.end());
    std::vector<Vector> places;
    if (from_)
    {
      places.push_back(*from_);
    }
    places.push_back(grid_.placeOf(points[0]));
    for (std::size_t i = 1; i < points.size(); ++i)
    {
      const Vector end = grid_.placeOf(points[i]);
      if (!walls_.areBetween(places.back(), end))
      {
        places.push_back(end);
        continue;
      }
      for (const std::size_t between : grid_.wayTo(points[i - 1], points[i]))
      {
        places.push_back(grid_.placeOf(between));
      }
    }
    places.push_back(to_);
    return places;
  }

  const PointGrid& grid_;
  const WallSearch& walls_;
  std::optional<Vector> from_; // levels
  Vector to_;
  double weight_;
  Execution& execution_;
  std::vector<float> length_;    // of the shortest way to each point
  std::vector<float> clearance_; // of each, once known
  std::vector<std::size_t> before_;
  using Reached = std::pair<float, std::size_t>;
  std::priority_queue<Reached, std::vector<Reached>, std::greater<>> queue_;
};

}

std::vector<Vector> findWay(const PointGrid& grid, const WallSearch& walls, const WayEnds& ends,
  double weight, Execution& execution)
{
  return LeakFinder(grid, walls, ends, weight, execution).run();
}

}
