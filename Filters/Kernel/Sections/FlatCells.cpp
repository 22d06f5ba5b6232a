// SPDX-License-Identifier: BSD-3-Clause
#include "Sections/FlatCells.h"

#include "Base/Error.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace cartesian
{

namespace
{

constexpr std::uint32_t NoNumber = ~0u;

class Sweeper
{
public:
  Sweeper(const SideFaces& side, const std::vector<double>& points, const SweepSpec& spec)
    : side_(side)
    , given_(points)
    , spec_(spec)
    , radial_(3 - spec.across - spec.axis)
    , ends_(points.size() / 3, { NoNumber, NoNumber })
  {
    result_.cells.firstFace.push_back(0);
    result_.cells.firstCorner.push_back(0);
  }

  FlatCells sweep()
  {
    if (spec_.isWedge)
    {
      placeAround();
    }
    else
    {
      placeAlong();
    }
    for (std::size_t polygon = 0; polygon < side_.count(); ++polygon)
    {
      addCell(polygon);
    }
    return std::move(result_);
  }

private:
  double at(std::uint32_t point, std::size_t axis) const
  {
    return given_[3 * std::size_t(point) + axis];
  }

  std::uint32_t add(Vector place, std::uint32_t point)
  {
    result_.points.insert(result_.points.end(), place.begin(), place.end());
    result_.pointOf.push_back(point);
    return static_cast<std::uint32_t>(result_.pointOf.size() - 1);
  }

  // Calls visit(point, ends) for each point of the side once.
  template <class Visitor>
  void forEachPoint(Visitor&& visit)
  {
    std::vector<std::uint32_t> points = side_.corners;
    std::sort(points.begin(), points.end());
    points.erase(std::unique(points.begin(), points.end()), points.end());
    for (const std::uint32_t point : points)
    {
      visit(point, ends_[point]);
    }
  }

  Vector placeOf(std::uint32_t point) const { return { at(point, 0), at(point, 1), at(point, 2) }; }

  void placeAlong()
  {
    const double thickness = spec_.thickness > 0 ? spec_.thickness : meanSide();
    forEachPoint([&](std::uint32_t point, std::array<std::uint32_t, 2>& ends) {
      Vector place = placeOf(point);
      ends[0] = add(place, point);
      place[spec_.across] += thickness;
      ends[1] = add(place, point);
    });
  }

  double meanSide() const
  {
    double area = 0;
    for (std::size_t polygon = 0; polygon < side_.count(); ++polygon)
    {
      const std::uint32_t* const c = side_.corners.data() + side_.firstCorner[polygon];
      const std::size_t size = side_.firstCorner[polygon + 1] - side_.firstCorner[polygon];
      Vector sum{};
      for (std::size_t i = 1; i + 1 < size; ++i)
      {
        const Vector base = placeOf(c[0]);
        sum = plus(sum, cross(minus(placeOf(c[i]), base), minus(placeOf(c[i + 1]), base)));
      }
      area += norm(sum) / 2;
    }
    return std::sqrt(area / static_cast<double>(side_.count()));
  }

  void placeAround()
  {
    const double angle = radians(spec_.angle) / 2;
    const double tolerance = SweepSpec::OnAxis * size();
    bool isAbove = false;
    bool isBelow = false;
    forEachPoint([&](std::uint32_t point, std::array<std::uint32_t, 2>& ends) {
      Vector place = placeOf(point);
      const double radius = place[radial_] - spec_.origin[radial_];
      if (std::abs(radius) <= tolerance)
      {
        place[radial_] = spec_.origin[radial_];
        place[spec_.across] = spec_.origin[spec_.across];
        ends[0] = ends[1] = add(place, point);
        return;
      }
      (radius > 0 ? isAbove : isBelow) = true;
      place[radial_] = spec_.origin[radial_] + radius * std::cos(angle);
      for (std::size_t i = 0; i < 2; ++i)
      {
        const double height = std::abs(radius) * std::sin(angle);
        place[spec_.across] = spec_.origin[spec_.across] + (i == 0 ? -height : height);
        ends[i] = add(place, point);
      }
    });
    if (isAbove && isBelow)
    {
      throw Error(Fault::BadParameter,
        "The side has faces on both sides of the axis: a wedge needs all of them on one. Move the "
        "Axis Origin, or let the mesh end at the axis.");
    }
  }

  double size() const
  {
    double size = 0;
    for (std::size_t axis = 0; axis < 3; ++axis)
    {
      double low = std::numeric_limits<double>::infinity();
      double high = -low;
      for (const std::uint32_t point : side_.corners)
      {
        low = std::min(low, at(point, axis));
        high = std::max(high, at(point, axis));
      }
      size = std::max(size, high - low);
    }
    return size;
  }

  void addCell(std::size_t polygon)
  {
    const std::size_t first = side_.firstCorner[polygon];
    const std::size_t size = side_.firstCorner[polygon + 1] - first;
    const auto ends = [&](std::size_t i) { return ends_[side_.corners[first + i % size]]; };
    for (std::size_t i = 0; i < size; ++i)
    {
      result_.cells.corners.push_back(ends(i)[0]);
    }
    finish(FrontFace);
    for (std::size_t i = size; i-- > 0;)
    {
      result_.cells.corners.push_back(ends(i)[1]);
    }
    finish(BackFace);
    for (std::size_t i = 0; i < size; ++i)
    {
      addEdge(ends(i), ends(i + 1), side_.beside[first + i]);
    }
    result_.cells.firstFace.push_back(result_.cells.firstCorner.size() - 1);
  }

  void addEdge(const std::array<std::uint32_t, 2>& from, const std::array<std::uint32_t, 2>& to,
    std::size_t beside)
  {
    const bool isFromOnAxis = from[0] == from[1];
    const bool isToOnAxis = to[0] == to[1];
    if (isFromOnAxis && isToOnAxis)
    {
      return;
    }
    auto& corners = result_.cells.corners;
    corners.push_back(to[0]);
    corners.push_back(from[0]);
    if (!isFromOnAxis)
    {
      corners.push_back(from[1]);
    }
    if (!isToOnAxis)
    {
      corners.push_back(to[1]);
    }
    finish(beside);
  }

  void finish(std::size_t source)
  {
    result_.cells.firstCorner.push_back(result_.cells.corners.size());
    result_.source.push_back(source);
  }

  const SideFaces& side_;
  const std::vector<double>& given_;
  const SweepSpec& spec_;
  std::size_t radial_;                             // the direction away from the axis
  std::vector<std::array<std::uint32_t, 2>> ends_; // of each point: in front, and behind
  FlatCells result_;
};

}

FlatCells sweep(const SideFaces& side, const std::vector<double>& points, const SweepSpec& spec)
{
  requireInRange(SweepSpec::Thicknesses, spec.thickness, "Thickness");
  requireInRange(SweepSpec::Angles, spec.angle, "Wedge Angle");
  if (spec.isWedge && spec.axis == spec.across)
  {
    throw Error(Fault::BadParameter,
      "The Axis of a wedge must lie in the side: choose another one than Across.");
  }
  if (side.count() == 0)
  {
    throw Error(Fault::BadMesh, "The mesh has no faces on its lower side.");
  }
  return Sweeper(side, points, spec).sweep();
}

}
