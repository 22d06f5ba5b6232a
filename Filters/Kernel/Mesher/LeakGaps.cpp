// SPDX-License-Identifier: BSD-3-Clause
#include "Mesher/LeakGaps.h"

#include "Mesher/LeakWay.h"

#include <algorithm>

namespace cartesian
{

namespace
{

constexpr double LeastRise = 1.5; // of the distance from walls, before and behind a gap

// The part of a search around a place.
LeakSearch around(const Vector& place, double reach, const LeakSearch& all)
{
  LeakSearch part = all;
  for (std::size_t axis = 0; axis < 3; ++axis)
  {
    part.low[axis] = static_cast<Level>(std::max(double(all.low[axis]), place[axis] - reach));
    part.high[axis] = static_cast<Level>(std::min(double(all.high[axis]), place[axis] + reach));
  }
  return part;
}

// Of a way: places on it, and their distances from walls.
struct Course
{
  std::vector<Vector> places;
  std::vector<double> clearance;

  Course(const std::vector<Vector>& points, const WallSearch& walls)
  {
    constexpr int Places = 8; // on each line
    for (std::size_t i = 0; i + 1 < points.size(); ++i)
    {
      for (int n = 0; n < Places; ++n)
      {
        places.push_back(
          plus(points[i], scaled(minus(points[i + 1], points[i]), double(n) / Places)));
      }
    }
    places.push_back(points.back());
    std::transform(places.begin(), places.end(), std::back_inserter(clearance),
      [&](const Vector& place) { return walls.distanceTo(place); });
  }

  // The narrowest places of gaps.
  std::vector<std::size_t> gaps() const
  {
    std::vector<std::size_t> found;
    std::size_t least = 0;
    double most = 0; // before that
    for (std::size_t i = 0; i < places.size(); ++i)
    {
      least = clearance[i] < clearance[least] ? i : least;
      const double rise = LeastRise * clearance[least];
      const bool isGap = most >= rise && clearance[i] >= rise;
      if (isGap)
      {
        found.push_back(least);
      }
      if (isGap || clearance[i] > most)
      {
        most = clearance[i];
        least = i;
      }
    }
    return found;
  }

  // The last place in either direction within a distance along each axis.
  std::size_t last(std::size_t i, double reach, bool isBehind) const
  {
    std::size_t j = i;
    while (j != (isBehind ? places.size() - 1 : 0))
    {
      const std::size_t next = isBehind ? j + 1 : j - 1;
      const Vector way = minus(places[next], places[i]);
      if (std::max({ std::abs(way[0]), std::abs(way[1]), std::abs(way[2]) }) > reach)
      {
        break;
      }
      j = next;
    }
    return j;
  }

  // Of those up to there, the one furthest from walls.
  std::size_t freest(std::size_t i, double reach, bool isBehind) const
  {
    const std::size_t end = last(i, reach, isBehind);
    std::size_t best = i;
    for (std::size_t j = std::min(i, end); j <= std::max(i, end); ++j)
    {
      best = clearance[j] > clearance[best] ? j : best;
    }
    return best;
  }
};

// Across the way, as the grid misses the middle by up to its spacing.
LeakGap inTheMiddle(const Course& course, std::size_t i, const WallSearch& walls)
{
  constexpr int Steps = 50;
  constexpr double MostMoved = 0.2; // times the distance from walls
  const Vector place = course.places[i];
  const double reach = course.clearance[i];
  const Vector along = unit(
    minus(course.places[course.last(i, reach, true)], course.places[course.last(i, reach, false)]));
  Vector middle = place;
  Vector wall = walls.nearest(middle);
  double step = MostMoved / 4;
  for (int n = 0; n < Steps; ++n)
  {
    Vector away = minus(middle, wall);
    away = minus(away, scaled(along, dot(along, away)));
    const Vector moved = plus(middle, scaled(away, step));
    const Vector nearest = walls.nearest(moved);
    const bool isBetter = norm(minus(moved, nearest)) > norm(minus(middle, wall)) &&
      norm(minus(moved, place)) < MostMoved * reach;
    step /= isBetter ? 1 : 2;
    wall = isBetter ? nearest : wall;
    middle = isBetter ? moved : middle;
  }
  const Vector half = minus(middle, wall);
  return { { wall, plus(middle, half) }, 2 * norm(half) };
}

class GapFinder
{
public:
  // `spacing`: of the points that the way was found with.
  GapFinder(const LeakSearch& search, double spacing, const WallSearch& walls, Execution& execution)
    : all_(search)
    , spacing_(spacing)
    , walls_(walls)
    , execution_(execution)
  {
  }

  // Coarsely until the place is in the middle, then finely.
  LeakGap gapAt(Course course, std::size_t i) const
  {
    constexpr int MostSearches = 8;
    constexpr double Coarse = 24; // points across
    constexpr double Fine = 40;
    constexpr double Growth = 1.05; // of the distance from walls, until the place is in the middle
    double before = 0;
    for (int n = 0; n < MostSearches && course.clearance[i] > Growth * before; ++n)
    {
      before = course.clearance[i];
      searchAround(Coarse, course, i);
    }
    searchAround(Fine, course, i);
    return inTheMiddle(course, i, walls_);
  }

private:
  // Searches again within some distance of the narrowest place, where walls alone count.
  void searchAround(double pointsAcross, Course& course, std::size_t& narrowest) const
  {
    constexpr double Reach = 4;      // times the distance from walls
    constexpr double LeastReach = 2; // times the spacing
    const double reach = std::max(Reach * course.clearance[narrowest], LeastReach * spacing_);
    const Vector from = course.places[course.freest(narrowest, reach, false)];
    const Vector to = course.places[course.freest(narrowest, reach, true)];
    const LeakSearch part = around(course.places[narrowest], reach, all_);
    PointGrid grid(part.low, part.high, 2 * reach / pointsAcross);
    grid.block(walls_.surface(), execution_);
    const std::vector<Vector> points = findWay(grid, walls_, { from, to }, 100 * reach, execution_);
    if (points.empty())
    {
      return;
    }
    course = Course(points, walls_);
    narrowest =
      static_cast<std::size_t>(std::min_element(course.clearance.begin(), course.clearance.end()) -
        course.clearance.begin());
  }

  const LeakSearch& all_;
  double spacing_;
  const WallSearch& walls_;
  Execution& execution_;
};

// Unless it is there: a way that grazes a rim has two narrow places there.
void addGap(const LeakGap& gap, std::vector<LeakGap>& gaps)
{
  const auto isSame = [&](const LeakGap& other) {
    const Vector apart = minus(gap.middle(), other.middle());
    return norm(apart) < std::min(gap.width, other.width) / 2;
  };
  if (std::none_of(gaps.begin(), gaps.end(), isSame))
  {
    gaps.push_back(gap);
  }
}

}

std::vector<LeakGap> gapsAlong(const std::vector<Vector>& points, double spacing,
  const LeakSearch& search, const WallSearch& walls, Execution& execution)
{
  const Course course(points, walls);
  const GapFinder finder(search, spacing, walls, execution);
  std::vector<LeakGap> gaps;
  for (const std::size_t i : course.gaps())
  {
    addGap(finder.gapAt(course, i), gaps);
  }
  return gaps;
}

}
