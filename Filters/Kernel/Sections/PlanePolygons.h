// SPDX-License-Identifier: BSD-3-Clause
// Polygons that divide a part of a plane: the faces on a flat side of a mesh, say.
#pragma once

#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace cartesian
{

using PlanePlace = std::array<double, 2>;

inline PlanePlace between(const PlanePlace& a, const PlanePlace& b, double t)
{
  return { a[0] + t * (b[0] - a[0]), a[1] + t * (b[1] - a[1]) };
}

inline double distance(const PlanePlace& a, const PlanePlace& b)
{
  return std::hypot(b[0] - a[0], b[1] - a[1]);
}

// Twice the area of a triangle, positive if it is counter-clockwise.
inline double turnOf(const PlanePlace& a, const PlanePlace& b, const PlanePlace& c)
{
  return (b[0] - a[0]) * (c[1] - a[1]) - (b[1] - a[1]) * (c[0] - a[0]);
}

// The place on the line from a to b that is nearest to p: 0 at a, 1 at b.
inline double footOn(const PlanePlace& a, const PlanePlace& b, const PlanePlace& p)
{
  const PlanePlace way{ b[0] - a[0], b[1] - a[1] };
  const double square = way[0] * way[0] + way[1] * way[1];
  return square > 0 ? ((p[0] - a[0]) * way[0] + (p[1] - a[1]) * way[1]) / square : 0;
}

// Corners counter-clockwise. Two polygons that have an edge in common have it with the same corners: a corner of one is a
// corner of all that touch it.
struct PlanePolygons
{
  std::vector<PlanePlace> points;
  std::vector<std::size_t> firstCorner{ 0 }; // of each polygon, and the end
  std::vector<std::uint32_t> corners;

  std::size_t count() const { return firstCorner.size() - 1; }
  std::size_t size(std::size_t polygon) const
  {
    return firstCorner[polygon + 1] - firstCorner[polygon];
  }
  std::uint32_t corner(std::size_t polygon, std::size_t i) const
  {
    return corners[firstCorner[polygon] + i % size(polygon)];
  }
};

constexpr std::uint32_t NoPolygon = ~std::uint32_t(0);

struct PlaneEdge
{
  std::uint32_t from;
  std::uint32_t to;
  std::array<std::uint32_t, 2> polygons; // to the left and to the right, or NoPolygon

  bool isOutline() const { return polygons[0] == NoPolygon || polygons[1] == NoPolygon; }
};

// Each once, by its ends, the lower of which is the first.
std::vector<PlaneEdge> edgesOf(const PlanePolygons& polygons);

}
