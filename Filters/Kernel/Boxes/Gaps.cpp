// SPDX-License-Identifier: BSD-3-Clause
#include "Boxes/Gaps.h"

#include "Boxes/OctantSearch.h"
#include "Lattice/LineMeeting.h"

#include <limits>

namespace cartesian
{

namespace
{

constexpr double Infinite = std::numeric_limits<double>::infinity();

// Lines are followed through a grid so many levels finer than the boxes; for deep boxes through one at most so many
// levels coarser than the deepest, if it has no more rows than these.
constexpr int LevelsFiner = 2;
constexpr int LevelsCoarser = 4;
constexpr double MostRows = 4e6;

// Of the angle between a line and the normal of the wall that it meets.
constexpr double LeastCosine = 0.5;

// Levels from a wall within which a line meets nothing: that is the wall itself.
constexpr double OwnWall = 2;

// Along each side of a piece of the surface, at most so many lines start, or two for each of the deepest boxes that
// the piece may be long.
constexpr int MostSamples = 64;

int levelsFiner(int largestDepth, const Meshlines& planes)
{
  const double rows = double(planes[1].size() - 1) * double(planes[2].size() - 1);
  int finer = std::min(largestDepth, LevelsFiner);
  while (finer < largestDepth - LevelsCoarser && std::ldexp(rows, 2 * (finer + 1)) <= MostRows)
  {
    ++finer;
  }
  return finer;
}

Meshlines dividedBy(int level, const Meshlines& planes)
{
  Meshlines result;
  for (std::size_t axis = 0; axis < 3; ++axis)
  {
    const auto fines = static_cast<std::int64_t>(planes[axis].size() - 1) * FinePerBox;
    for (std::int64_t fine = 0; fine <= fines; fine += FinePerBox >> level)
    {
      result[axis].push_back(planeAt(planes, axis, fine));
    }
  }
  return result;
}

// The interval of planes that holds a place; the first or last for one beyond.
std::size_t intervalAround(const std::vector<Level>& planes, double place)
{
  const auto after = std::upper_bound(planes.begin() + 1, planes.end() - 1, place);
  return static_cast<std::size_t>(after - planes.begin()) - 1;
}

Vector between(const Vector& a, const Vector& b, double part)
{
  return plus(a, scaled(minus(b, a), part));
}

// How far along a line from `start` a triangle is; infinite where it is not met.
double distanceTo(const Corners& c, const Vector& start, const Vector& direction)
{
  const LineMeeting m = meetLine(c, start, direction);
  if (m.second >= 0 && m.third >= 0 && m.second + m.third <= 1)
  {
    return m.distance;
  }
  return Infinite; // of parallels too: they have NaN
}

class Gaps
{
public:
  Gaps(const SizingSpec& spec, const Surface& surface, const Meshlines& planes,
    const Octants& octants, Execution& execution)
    : spec_(spec)
    , surface_(surface)
    , planes_(planes)
    , octants_(octants)
    , finer_(levelsFiner(spec.largestDepth, planes))
    , mostSamples_(std::max(MostSamples, 2 << (spec.largestDepth - finer_)))
    , finePlanes_(dividedBy(finer_, planes))
    , fine_(fillShoeboxes(surface, finePlanes_, execution))
  {
  }

  std::vector<std::vector<Octants::Key>> find(Execution& execution) const
  {
    std::vector<std::vector<Octants::Key>> found =
      findOctants<NoScratch>(fine_, finePlanes_, execution,
        [&](const std::array<std::uint32_t, 3>& box, const TriangleRange& triangles, NoScratch&,
          std::vector<Octants::Key>& mine) {
          const auto before = static_cast<std::ptrdiff_t>(mine.size());
          lookFrom({ box[0], box[1], box[2] }, triangles, mine);
          leaveOutTwins(mine, before);
        });
    for (std::vector<Octants::Key>& keys : found)
    {
      leaveOutTwins(keys, 0);
    }
    return found;
  }

private:
  using Cell = std::array<std::size_t, 3>; // of the finer grid

  static void leaveOutTwins(std::vector<Octants::Key>& keys, std::ptrdiff_t begin)
  {
    std::sort(keys.begin() + begin, keys.end());
    keys.erase(std::unique(keys.begin() + begin, keys.end()), keys.end());
  }

  std::size_t rowsAlongY() const { return finePlanes_[1].size() - 1; }

  TriangleRange trianglesOf(const Cell& cell) const
  {
    return fine_.triangles(cell[1] + cell[2] * rowsAlongY(), static_cast<std::uint32_t>(cell[0]));
  }

  double sizeAround(const Vector& place) const
  {
    double size = 0;
    for (std::size_t axis = 0; axis < 3; ++axis)
    {
      const std::size_t i = intervalAround(planes_[axis], place[axis]);
      size = std::max(size, double(planes_[axis][i + 1]) - planes_[axis][i]);
    }
    return size;
  }

  struct NoScratch
  {
  };

  void lookFrom(
    const Cell& cell, const TriangleRange& triangles, std::vector<Octants::Key>& found) const
  {
    Point low;
    Point high;
    for (std::size_t axis = 0; axis < 3; ++axis)
    {
      low[axis] = finePlanes_[axis][cell[axis]];
      high[axis] = finePlanes_[axis][cell[axis] + 1];
    }
    for (const std::uint32_t* t = triangles.first; t != triangles.second; ++t)
    {
      const Corners corners = surface_.corners(*t);
      const Vector out = unit(cross(minus(corners[1], corners[0]), minus(corners[2], corners[0])));
      const Fragment fragment = clip(corners, low, high);
      if (fragment.size > 0 && norm(out) > 0)
      {
        lookFrom(*t, fragment, scaled(out, -1), found);
        if (hasTwoSides(*t))
        {
          lookFrom(*t, fragment, out, found);
        }
      }
    }
  }

  // Or may have, as far as is known.
  bool hasTwoSides(std::uint32_t t) const
  {
    return surface_.walls.any() || (!surface_.byParity.empty() && surface_.byParity[t] != 0);
  }

  // First lines as far apart as the finer grid's; where boxes must be smaller, closer ones.
  void lookFrom(std::uint32_t t, const Fragment& fragment, const Vector& direction,
    std::vector<Octants::Key>& found) const
  {
    const double size = sizeAround(toVector(fragment.corner[0]));
    int level = 0;
    const auto look = [&](const Vector& start) {
      const double distance = distanceAcross(t, start, direction);
      const int own = levelAcross(start, distance);
      if (own > 0)
      {
        follow(start, direction, distance, own, found);
      }
      level = std::max(level, own);
    };
    forEachSample(fragment, size / (1 << finer_), look);
    if (level > finer_)
    {
      forEachSample(fragment, size / (1 << level), look);
    }
  }

  // The least level of boxes around a place of which enough fit into a gap, or the largest allowed.
  int levelAcross(const Vector& place, double distance) const
  {
    constexpr double Rounding = 1e-9;
    const double wanted = distance / spec_.cellsAcrossGaps * (1 + Rounding);
    double size = sizeAround(place);
    int level = 0;
    for (; size > wanted && level < spec_.largestDepth; ++level)
    {
      size /= 2;
    }
    return level;
  }

  // The distance from a place on triangle `t` to a wall that faces it; infinite if enough boxes fit between.
  double distanceAcross(std::uint32_t t, const Vector& start, const Vector& direction) const
  {
    const double most = spec_.cellsAcrossGaps * sizeAround(start);
    Cell cell;
    for (std::size_t axis = 0; axis < 3; ++axis)
    {
      cell[axis] = intervalAround(finePlanes_[axis], start[axis]);
    }
    Met met{ Infinite, t };
    for (;;)
    {
      const auto [leaves, axis] = endOf(cell, start, direction);
      meet(cell, t, start, direction, met);
      if (met.distance <= leaves)
      {
        if (!isFacing(met.triangle, direction))
        {
          return Infinite;
        }
        return met.distance;
      }
      const bool up = direction[axis] > 0;
      const bool isLast = cell[axis] == (up ? finePlanes_[axis].size() - 2 : 0);
      if (isLast || leaves > most)
      {
        const bool isWall = isLast && surface_.around.inside();
        if (!isWall || std::abs(direction[axis]) < LeastCosine)
        {
          return Infinite;
        }
        return leaves;
      }
      cell[axis] = up ? cell[axis] + 1 : cell[axis] - 1;
    }
  }

  // The first triangle that a line meets.
  struct Met
  {
    double distance;
    std::uint32_t triangle;
  };

  // Of the triangles in a cell other than `own`, unless what was met is nearer.
  void meet(const Cell& cell, std::uint32_t own, const Vector& start, const Vector& direction,
    Met& met) const
  {
    const TriangleRange triangles = trianglesOf(cell);
    for (const std::uint32_t* t = triangles.first; t != triangles.second; ++t)
    {
      const double distance = *t == own ? 0 : distanceTo(surface_.corners(*t), start, direction);
      if (distance > OwnWall && distance < met.distance)
      {
        met = { distance, *t };
      }
    }
  }

  // Where a line leaves a cell: how far from its start, and across which axis.
  std::pair<double, std::size_t> endOf(
    const Cell& cell, const Vector& start, const Vector& direction) const
  {
    std::pair<double, std::size_t> end{ Infinite, 0 };
    for (std::size_t axis = 0; axis < 3; ++axis)
    {
      const std::size_t plane = cell[axis] + (direction[axis] > 0 ? 1 : 0);
      const double along = double(finePlanes_[axis][plane]) - start[axis];
      const double distance = direction[axis] == 0 ? Infinite : along / direction[axis];
      end = std::min(end, { distance, axis });
    }
    return end;
  }

  bool isFacing(std::uint32_t t, const Vector& direction) const
  {
    const Corners c = surface_.corners(t);
    const double cosine = dot(unit(cross(minus(c[1], c[0]), minus(c[2], c[0]))), direction);
    return (hasTwoSides(t) ? std::abs(cosine) : cosine) >= LeastCosine;
  }

  // Lists the octants along a line.
  void follow(const Vector& start, const Vector& direction, double distance, int level,
    std::vector<Octants::Key>& found) const
  {
    constexpr int StepsAnOctant = 2;
    const double step = sizeAround(start) / (StepsAnOctant << level);
    const auto steps = static_cast<int>(std::ceil(distance / step));
    Octants::Key last{ ~std::uint64_t(0), 0 };
    for (int i = 0; i <= steps; ++i)
    {
      const Octant octant =
        octantAround(plus(start, scaled(direction, std::min(i * step, distance))), level);
      const Octants::Key key = octants_.keyOf(octant);
      if (key != last)
      {
        found.push_back(key);
      }
      last = key;
    }
  }

  Octant octantAround(const Vector& place, int level) const
  {
    Octant octant;
    octant.level = level;
    for (std::size_t axis = 0; axis < 3; ++axis)
    {
      const std::vector<Level>& planes = planes_[axis];
      const std::size_t i = intervalAround(planes, place[axis]);
      const double low = planes[i];
      const double along = (place[axis] - low) / (double(planes[i + 1]) - low);
      octant.global[axis] = static_cast<std::uint32_t>(i);
      octant.position[axis] = static_cast<std::uint32_t>(
        std::clamp(std::floor(along * (1 << level)), 0., double((1 << level) - 1)));
    }
    return octant;
  }

  // The mean of the corners, and how far the furthest is from it.
  static std::pair<Vector, double> middleOf(const Fragment& fragment)
  {
    std::pair<Vector, double> result{};
    const auto size = static_cast<std::size_t>(fragment.size);
    for (std::size_t i = 0; i < size; ++i)
    {
      result.first = plus(result.first, scaled(toVector(fragment.corner[i]), 1. / fragment.size));
    }
    for (std::size_t i = 0; i < size; ++i)
    {
      result.second =
        std::max(result.second, norm(minus(toVector(fragment.corner[i]), result.first)));
    }
    return result;
  }

  // Calls visit(place) with places of a piece of a triangle that are about `spacing` apart.
  template <class Visitor>
  void forEachSample(const Fragment& fragment, double spacing, Visitor&& visit) const
  {
    const Vector a = toVector(fragment.corner[0]);
    if (const auto [middle, reach] = middleOf(fragment); reach < spacing / 2)
    {
      visit(middle);
      return;
    }
    for (std::size_t i = 1; i + 1 < static_cast<std::size_t>(fragment.size); ++i)
    {
      const Vector b = toVector(fragment.corner[i]);
      const Vector c = toVector(fragment.corner[i + 1]);
      const double longest = std::max({ norm(minus(b, a)), norm(minus(c, b)), norm(minus(a, c)) });
      const auto n = static_cast<int>(std::clamp(std::ceil(longest / spacing), 1., mostSamples_));
      for (int row = 0; row < n; ++row)
      {
        for (int column = 0; column <= row; ++column)
        {
          // The middle of a triangle that is n times smaller.
          const double toEdge = (row + 2. / 3) / n;
          const double along = (column + 1. / 3) / (row + 2. / 3);
          visit(between(a, between(b, c, along), toEdge));
        }
      }
    }
  }

  const SizingSpec& spec_;
  const Surface& surface_;
  const Meshlines& planes_;
  const Octants& octants_;
  const int finer_;
  const double mostSamples_;
  const Meshlines finePlanes_;
  const Shoeboxes fine_;
};

}

void addGaps(const SizingSpec& spec, const Surface& surface, const Meshlines& planes,
  Octants& octants, Execution& execution)
{
  std::vector<std::vector<Octants::Key>> found =
    Gaps(spec, surface, planes, octants, execution).find(execution);
  octants.add(found);
}

}
