// SPDX-License-Identifier: BSD-3-Clause
// What faces are measured by, as OpenFOAM and section 3 define it. Any unit of length; any numbers, as CellGeometry.h.
#pragma once

#include "Polyhedra/CellGeometry.h"

#include <limits>

namespace cartesian
{

inline const Vector& valuesOf(const Vector& v)
{
  return v;
}

template <class Number>
struct FaceMeasures
{
  VectorOf<Number> centre;
  VectorOf<Number> area;
  Number star; // the smallest triangle around the mean of the corners, by the mean one; at most 1
  Number warp; // 1 - the area by the sum of the triangles'
};

// Of a polygon with corner(0) to corner(size - 1). One without area has the worst values, -1 and 1.
template <class Corner>
FaceMeasures<NumberOf<Corner>> measuresOfFace(std::size_t size, Corner&& corner)
{
  using Number = NumberOf<Corner>;
  if (size == 3)
  {
    const FaceGeometryOf<Number> triangle = measureTriangle(corner);
    return { triangle.centre, triangle.area, Number(1), Number(0) };
  }
  constexpr std::size_t Kept = 16;
  std::array<Vector, Kept> triangles; // the first of them
  std::size_t count = 0;
  const StarSums<Number> sums = sumStar(size, corner, [&](const VectorOf<Number>& triangle) {
    triangles[std::min(count++, Kept - 1)] = valuesOf(triangle);
  });
  const FaceGeometryOf<Number> face = sums.geometry();
  const Number square = dot(face.area, face.area);
  if (!(valueOf(sums.size) > Tiny && valueOf(square) > Tiny))
  {
    return { face.centre, face.area, Number(-1), Number(1) };
  }
  const auto triangleAt = [&](std::size_t i) -> VectorOf<Number> {
    return scaled(
      cross(minus(corner(i == 0 ? size - 1 : i - 1), sums.mean), minus(corner(i), sums.mean)), 0.5);
  };
  std::size_t smallest = 0;
  double least = std::numeric_limits<double>::infinity();
  for (std::size_t i = 0; i < size; ++i)
  {
    const double product =
      dot(i + 1 < Kept ? triangles[i] : valuesOf(triangleAt(i)), valuesOf(face.area));
    smallest = product < least ? i : smallest;
    least = std::min(product, least);
  }
  using std::sqrt;
  const Number star = dot(triangleAt(smallest), face.area) * double(size) / square;
  return { face.centre, face.area, star > Number(1) ? Number(1) : star,
    Number(1) - sqrt(square) / sums.size };
}

// Polygons count as flat up to this angle, in degrees, between a star triangle and the whole.
constexpr double FlatUpTo = 15;

// Whether a polygon is not flat: the paper's IP patches (4.11).
template <class Corner>
bool isBent(std::size_t size, Corner&& corner, const Vector& area)
{
  const double least = std::cos(radians(FlatUpTo));
  bool bent = false;
  forEachStarTriangle(size, corner, [&](const Vector&, const Vector&, const Vector& triangle) {
    bent = bent || dot(triangle, area) < least * norm(triangle) * norm(area);
  });
  return bent;
}

// Skewness is measured over at least these parts of the distance between the centres, and of the height above a
// boundary face.
constexpr double ShareOfDistance = 0.2;
constexpr double ShareOfHeight = 0.4;

// OpenFOAM's skewness of a face: how far its centre is from where the line between the centres of its cells meets its
// plane (at the boundary: from the foot of the cell's centre), by how far the face reaches in that direction. `aside`: from
// there to the centre; `least`: the reach that counts at least.
template <class Number, class Corner>
Number skewness(std::size_t size, Corner&& corner, const VectorOf<Number>& centre,
  const VectorOf<Number>& aside, const Number& least)
{
  using std::abs;
  using std::sqrt;
  const Number square = dot(aside, aside);
  if (!(valueOf(square) > Tiny))
  {
    return Number(0);
  }
  Number reach = least * sqrt(square); // times the length of `aside`
  for (std::size_t i = 0; i < size; ++i)
  {
    const Number there = abs(dot(minus(VectorOf<Number>(corner(i)), centre), aside));
    reach = reach < there ? there : reach;
  }
  return square / reach;
}

}
