// SPDX-License-Identifier: BSD-3-Clause
#include "Mesher/LeakPath.h"

#include "Lattice/NearestPlace.h"
#include "Mesher/PointGrid.h"
#include "Repair/TriangleTree.h"

#include <algorithm>
#include <limits>
#include <optional>
#include <queue>
#include <tuple>

namespace cartesian
{

namespace
{

// The most points of each search, in turn.
constexpr std::array<double, 3> Searches{ 3e5, 2.4e6, 2e7 };

constexpr double WallWeight = 0.1; // of walls, as a part of the distance of the two ends
constexpr double LeastRise = 1.5;  // of the distance from walls, before and behind a gap

class WallSearch
{
public:
  WallSearch(const Surface& walls, Execution& execution)
    : walls_(walls)
    , tree_(walls, execution)
  {
  }

  Vector nearest(const Vector& place) const
  {
    const auto nearestOf = [&](std::uint32_t t) { return nearestPlace(walls_.corners(t), place); };
    return nearestOf(
      tree_.nearest(place, [&](std::uint32_t t) { return norm(minus(nearestOf(t), place)); }));
  }

  double distanceTo(const Vector& place) const { return norm(minus(nearest(place), place)); }

  // Whether a segment passes through one.
  bool areBetween(const Vector& from, const Vector& to) const
  {
    Vector low;
    Vector high;
    for (std::size_t axis = 0; axis < 3; ++axis)
    {
      std::tie(low[axis], high[axis]) = std::minmax(from[axis], to[axis]);
    }
    bool are = false;
    tree_.forEachWithin(low, high, [&](std::uint32_t t) { are = are || passes(from, to, t); });
    return are;
  }

private:
  bool passes(const Vector& from, const Vector& to, std::uint32_t triangle) const
  {
    std::array<Vector, 3> c;
    for (std::size_t i = 0; i < 3; ++i)
    {
      c[i] = minus(toVector(walls_.corners(triangle)[i]), from);
    }
    const Vector along = minus(to, from);
    const Vector normal = cross(minus(c[1], c[0]), minus(c[2], c[0]));
    const bool isAbove = dot(normal, c[0]) > 0;
    const auto side = [&](std::size_t i) { return dot(along, cross(c[i], c[(i + 1) % 3])) > 0; };
    return isAbove != (dot(normal, minus(c[0], along)) > 0) && side(0) == side(1) &&
      side(1) == side(2);
  }

  const Surface& walls_;
  TriangleTree tree_;
};

Vector toLevels(const Vector& place, const Lattice& lattice)
{
  Vector levels;
  for (std::size_t axis = 0; axis < 3; ++axis)
  {
    levels[axis] = (place[axis] - lattice.position(static_cast<int>(axis), 0)) / lattice.step();
  }
  return levels;
}

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

// Dijkstra's algorithm on the grid; of equally long ways the one by points with lower numbers.
class LeakFinder
{
public:
  // Places in levels; `weight`: of walls, so many levels.
  LeakFinder(const PointGrid& grid, const WallSearch& walls, const std::optional<Vector>& from,
    const Vector& to, double weight)
    : grid_(grid)
    , walls_(walls)
    , from_(from)
    , to_(to)
    , weight_(weight)
    , length_(grid.size(), std::numeric_limits<float>::infinity())
    , clearance_(grid.size(), -1)
    , before_(grid.size(), None)
  {
  }

  // Places from one end to the other; none: they are not connected.
  std::vector<Vector> run()
  {
    start();
    const std::array<std::size_t, 8> ends = grid_.pointsAround(to_);
    while (!queue_.empty())
    {
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
  std::vector<float> length_;    // of the shortest way to each point
  std::vector<float> clearance_; // of each, once known
  std::vector<std::size_t> before_;
  using Reached = std::pair<float, std::size_t>;
  std::priority_queue<Reached, std::vector<Reached>, std::greater<>> queue_;
};

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

// Searches again within some distance of the narrowest place, where walls alone count.
void searchAround(double reach, double pointsAcross, const LeakSearch& all, const Surface& surface,
  const WallSearch& walls, Course& course, std::size_t& narrowest)
{
  const Vector from = course.places[course.freest(narrowest, reach, false)];
  const Vector to = course.places[course.freest(narrowest, reach, true)];
  const LeakSearch part = around(course.places[narrowest], reach, all);
  PointGrid grid(part.low, part.high, 2 * reach / pointsAcross);
  grid.block(surface);
  const std::vector<Vector> points = LeakFinder(grid, walls, from, to, 100 * reach).run();
  if (points.empty())
  {
    return;
  }
  course = Course(points, walls);
  narrowest = static_cast<std::size_t>(
    std::min_element(course.clearance.begin(), course.clearance.end()) - course.clearance.begin());
}

Vector middleOf(const LeakGap& gap)
{
  return scaled(plus(gap.across[0], gap.across[1]), 0.5);
}

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

// Coarsely until the place is in the middle, then finely. `spacing`: of the points that the way was found with.
LeakGap gapAt(Course course, std::size_t i, double spacing, const LeakSearch& all,
  const Surface& surface, const WallSearch& walls)
{
  constexpr int MostSearches = 8;
  constexpr double Coarse = 24; // points across
  constexpr double Fine = 40;
  constexpr double Reach = 4;      // times the distance from walls
  constexpr double LeastReach = 2; // times the spacing
  constexpr double Growth = 1.05;  // of the distance from walls, until the place is in the middle
  const auto search = [&](double pointsAcross) {
    const double reach = std::max(Reach * course.clearance[i], LeastReach * spacing);
    searchAround(reach, pointsAcross, all, surface, walls, course, i);
  };
  double before = 0;
  for (int n = 0; n < MostSearches && course.clearance[i] > Growth * before; ++n)
  {
    before = course.clearance[i];
    search(Coarse);
  }
  search(Fine);
  return inTheMiddle(course, i, walls);
}

// Unless it is there: a way that grazes a rim has two narrow places there.
void addGap(const LeakGap& gap, LeakPath& path)
{
  const auto isSame = [&](const LeakGap& other) {
    const Vector apart = minus(middleOf(gap), middleOf(other));
    return norm(apart) < std::min(gap.width, other.width) / 2;
  };
  if (std::none_of(path.gaps.begin(), path.gaps.end(), isSame))
  {
    path.gaps.push_back(gap);
  }
}

LeakPath inUserUnits(LeakPath path, const Lattice& lattice)
{
  const auto convert = [&](Vector& at) {
    for (std::size_t axis = 0; axis < 3; ++axis)
    {
      at[axis] = lattice.position(static_cast<int>(axis), 0) + lattice.step() * at[axis];
    }
  };
  std::for_each(path.points.begin(), path.points.end(), convert);
  for (LeakGap& gap : path.gaps)
  {
    std::for_each(gap.across.begin(), gap.across.end(), convert);
    gap.width *= lattice.step();
  }
  return path;
}

std::string describe(const LeakSearch& search, const LeakPath& path)
{
  constexpr std::size_t MostNamed = 5;
  if (!search.from && path.points.empty())
  {
    return search.to->name +
      " lies in a space that is meshed: move or remove it, or give Keep Points in the spaces to be "
      "meshed.";
  }
  const std::size_t gaps = path.gaps.size();
  std::string text = search.to->name + " is reached from " +
    (search.from ? search.from->name : "the sides of the domain box");
  text += gaps == 0 ? "" : " through " + std::to_string(gaps) + (gaps == 1 ? " gap: " : " gaps: ");
  for (std::size_t i = 0; i < std::min(gaps, MostNamed); ++i)
  {
    const LeakGap& gap = path.gaps[i];
    const double unit = gap.width / 1000;
    Vector at = middleOf(gap);
    std::transform(
      at.begin(), at.end(), at.begin(), [&](double x) { return std::round(x / unit) * unit; });
    text += (i == 0 ? "" : ", ") + number(gap.width) + " wide at (" + number(at[0]) + ", " +
      number(at[1]) + ", " + number(at[2]) + ")";
  }
  text += gaps > MostNamed ? ", ..." : "";
  text += gaps == 0
    ? ". Move or remove one of the points, or add the wall between them."
    : ". Close the gaps, in the surface or by Close Gaps, or move or remove one of the points.";
  return text + (path.points.empty() ? "" : " The output Defects shows the way.");
}

}

double LeakSearch::diagonal() const
{
  return norm(minus(toVector(high), toVector(low)));
}

double LeakSearch::spacingOf(double points) const
{
  double volume = 1;
  for (std::size_t axis = 0; axis < 3; ++axis)
  {
    volume *= double(high[axis]) - low[axis];
  }
  return std::cbrt(volume / points);
}

LeakPath findLeak(const Surface& walls, const LeakSearch& search, Execution& execution)
{
  const WallSearch wallSearch(walls, execution);
  const Vector to = toLevels(search.to->place, walls.lattice);
  std::optional<Vector> from;
  double across = search.diagonal();
  if (search.from)
  {
    from = toLevels(search.from->place, walls.lattice);
    across = norm(minus(to, *from));
  }
  LeakPath path;
  double spacing = search.spacing;
  for (const double most : Searches)
  {
    spacing = std::max(spacing, search.spacingOf(most));
    PointGrid grid(search.low, search.high, spacing);
    grid.block(walls);
    path.points = LeakFinder(grid, wallSearch, from, to, WallWeight * across).run();
    if (!path.points.empty())
    {
      const Course course(path.points, wallSearch);
      for (const std::size_t i : course.gaps())
      {
        addGap(gapAt(course, i, spacing, search, walls, wallSearch), path);
      }
      break;
    }
    spacing /= 2;
  }
  return inUserUnits(std::move(path), walls.lattice);
}

Leak::Leak(const LeakSearch& search, LeakPath way)
  : Error(Fault::BadParameter, describe(search, way))
  , path(std::move(way))
{
}

}
