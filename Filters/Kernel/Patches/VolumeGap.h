// SPDX-License-Identifier: BSD-3-Clause
// The volume that the surface encloses in a box and its patches do not: those of Marching Cubes are chords of the
// surface, which lie inside of it where it is convex (a polygon of n chords lacks 6.6 / n^2 of its circle).
#pragma once

#include "Patches/BoxSurface.h"
#include "Patches/Patches.h"
#include "Polyhedra/CellGeometry.h"

namespace cartesian
{

// The space behind polygons in one box, in cubic levels, up to a number that only depends on where they cross the box's
// edges: so the surface and its patches can be compared.
class SpaceBehind
{
public:
  explicit SpaceBehind(const Box& box)
    : box_(box)
    , centre_(scaled(minus(box.high, box.low), 0.5))
  {
  }

  // point(i) of `size` corners.
  template <class PointAt>
  void add(std::size_t size, PointAt&& point)
  {
    const auto at = [&](std::size_t i) { return minus(minus(point(i), box_.low), centre_); };
    Vector cone{};
    const Vector mean =
      forEachStarTriangle(size, at, [&](const Vector&, const Vector&, const Vector& triangle) {
        cone = plus(cone, triangle);
        area_ += norm(triangle);
      });
    sum_ += dot(mean, cone) / 3;
    for (std::size_t i = 0; i < size; ++i)
    {
      addSides(point(i), point(i + 1 < size ? i + 1 : 0));
    }
  }

  double sum() const { return sum_; }
  double area() const { return area_; }

private:
  // What an edge on a side of the box takes from what lies behind there on that side.
  void addSides(const Point& p, const Point& q)
  {
    const unsigned planes = planesOf(box_, p) & planesOf(box_, q);
    for (std::size_t side = 0; planes >> side != 0; ++side)
    {
      if ((planes >> side & 1u) != 0)
      {
        const std::size_t axis = side / 2;
        const double outwards = side % 2 == 1 ? 1 : -1;
        const Vector from = minus(minus(p, box_.low), centre_);
        const Vector to = minus(minus(q, box_.low), centre_);
        sum_ -= centre_[axis] * outwards * cross(from, to)[axis] / 6;
      }
    }
  }

  const Box box_;
  const Vector centre_;
  double sum_ = 0;
  double area_ = 0;
};

// Of the surface itself.
inline double spaceBehind(const Box& box, const BoxSurface& piece)
{
  SpaceBehind space(box);
  const std::uint32_t* corner = piece.corners.data();
  for (const std::uint32_t size : piece.sizes)
  {
    space.add(size, [&](std::size_t i) { return piece.points[corner[i]]; });
    corner += size;
  }
  return space.sum();
}

// Of the patches of the n-th intersected box.
inline SpaceBehind spaceBehind(const Box& box, const Patches& patches, std::size_t n)
{
  SpaceBehind space(box);
  for (std::size_t p = patches.boxStart[n]; p < patches.boxStart[n + 1]; ++p)
  {
    const std::size_t first = patches.start[p];
    space.add(patches.start[p + 1] - first,
      [&](std::size_t i) { return patches.points[patches.corners[first + i]]; });
  }
  return space;
}

// By the area of the patches.
inline float missingBy(double behindSurface, const SpaceBehind& ofPatches)
{
  return static_cast<float>((behindSurface - ofPatches.sum()) / std::max(ofPatches.area(), Tiny));
}

}
