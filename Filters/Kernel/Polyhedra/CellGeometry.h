// SPDX-License-Identifier: BSD-3-Clause
// Centres, areas and volumes of polygons and polyhedra as OpenFOAM computes them, and the angles of
// section 3. Works in any unit of length.
#pragma once

#include "Lattice/StarPolygons.h"
#include "Lattice/Vector.h"

#include <algorithm>
#include <cstdint>
#include <limits>

namespace cartesian
{

// Smaller areas and volumes count as zero; this only keeps divisors from vanishing.
constexpr double Tiny = 1e-150;

// A polygon of some nodes, counter-clockwise from outside.
struct Ring
{
  const Vector* nodes;
  const std::uint32_t* corners;
  std::size_t size;

  const Vector& operator[](std::size_t i) const { return nodes[corners[i]]; }
};

struct FaceGeometry
{
  Vector centre; // area-weighted mean of the star triangles' centres
  Vector area;   // sum of the star triangles' area vectors (equation 1), positive counter-clockwise
};

// How the areas of a cell's faces spread over three directions: solvers invert the sum of their squares, divided by
// their lengths, to reconstruct velocity from fluxes (OpenFOAM's fvc::reconstruct).
class AreaSpread
{
public:
  void add(const Vector& area)
  {
    const double size = norm(area) + Tiny;
    for (std::size_t axis = 0; axis < 3; ++axis)
    {
      sum_[axis] = plus(sum_[axis], scaled(area, area[axis] / size));
    }
  }

  // The smallest eigenvalue of the sum by the next larger one, about: 1 for a cube, 0 where no face has a third direction.
  double third() const
  {
    const double trace = sum_[0][0] + sum_[1][1] + sum_[2][2];
    const double minors =
      cross(sum_[1], sum_[2])[0] + cross(sum_[2], sum_[0])[1] + cross(sum_[0], sum_[1])[2];
    return 3 * dot(sum_[0], cross(sum_[1], sum_[2])) * trace / std::max(minors * minors, Tiny);
  }

private:
  std::array<Vector, 3> sum_{};
};

// Calls visit(p, q, area) for the star triangles around the mean of a face's corners, corner(0) to
// corner(size - 1): two corners relative to the mean, and the triangle's area vector. Returns the
// mean.
template <class Corner, class Visitor>
Vector forEachStarTriangle(std::size_t size, Corner&& corner, Visitor&& visit)
{
  const Vector origin = corner(0); // sums are relative to this, for accuracy
  Vector mean{ 0, 0, 0 };
  for (std::size_t i = 1; i < size; ++i)
  {
    mean = plus(mean, minus(corner(i), origin));
  }
  mean = plus(origin, scaled(mean, 1.0 / static_cast<double>(size)));
  Vector p = minus(corner(size - 1), mean);
  for (std::size_t i = 0; i < size; ++i)
  {
    const Vector q = minus(corner(i), mean);
    visit(p, q, scaled(cross(p, q), 0.5));
    p = q;
  }
  return mean;
}

// Calls visit(area) for the triangles of its star, unless it is a triangle.
template <class Corner, class Visitor>
FaceGeometry measureFace(std::size_t size, Corner&& corner, Visitor&& visit)
{
  if (size == 3)
  {
    const Vector p = minus(corner(1), corner(0));
    const Vector q = minus(corner(2), corner(0));
    return { plus(corner(0), scaled(plus(p, q), 1.0 / 3)), scaled(cross(p, q), 0.5) };
  }
  Vector area{ 0, 0, 0 };
  Vector moment{ 0, 0, 0 };
  double sum = 0;
  const Vector mean = forEachStarTriangle(
    size, corner, [&](const Vector& p, const Vector& q, const Vector& triangle) {
      const double part = norm(triangle);
      area = plus(area, triangle);
      moment = plus(moment, scaled(plus(p, q), part / 3));
      sum += part;
      visit(triangle);
    });
  return { sum < Tiny ? mean : plus(mean, scaled(moment, 1 / sum)), area };
}

template <class Corner>
FaceGeometry measureFace(std::size_t size, Corner&& corner)
{
  return measureFace(size, corner, [](const Vector&) {});
}

// The least of a star's triangles, by the products of their areas with that of the whole.
class StarShare
{
public:
  void add(double product) { least_ = std::min(least_, product); }

  // Relative to the mean of so many, at most 1; without any, 1.
  double smallest(std::size_t size, const Vector& area) const
  {
    const double mean = dot(area, area) / static_cast<double>(size) + Tiny;
    return std::min(1.0, least_ / mean); // the least divided is the least of those divided
  }

private:
  double least_ = std::numeric_limits<double>::infinity();
};

// The area of the smallest star triangle relative to the mean one; negative if it is inverted.
template <class Corner>
double smallestOfStar(std::size_t size, Corner&& corner, const Vector& area)
{
  StarShare share;
  if (size > 3)
  {
    forEachStarTriangle(size, corner, [&](const Vector&, const Vector&, const Vector& triangle) {
      share.add(dot(triangle, area));
    });
  }
  return share.smallest(size, area);
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

struct CellGeometry
{
  Vector centre; // of mass, from the pyramids between the faces and the mean of their centres
  double volume;
};

// A cell of `size` faces, face(i), with outward areas.
template <class Face>
CellGeometry measureCell(std::size_t size, Face&& face)
{
  Vector mean{ 0, 0, 0 };
  for (std::size_t i = 0; i < size; ++i)
  {
    mean = plus(mean, scaled(face(i).centre, 1.0 / static_cast<double>(size)));
  }
  Vector moment{ 0, 0, 0 };
  double volume = 0;
  for (std::size_t i = 0; i < size; ++i)
  {
    const FaceGeometry& f = face(i);
    const Vector height = minus(f.centre, mean);
    volume += dot(f.area, height) / 3;
    moment = plus(moment, scaled(height, dot(f.area, height) / 4));
  }
  return { std::abs(volume) < Tiny ? mean : plus(mean, scaled(moment, 1 / volume)), volume };
}

// In degrees, 0 to 180; 90 if one of the vectors is zero.
inline double angle(const Vector& u, const Vector& v)
{
  constexpr double Degrees = 180 / Pi;
  const double sine = norm(cross(u, v));
  const double cosine = dot(u, v);
  return Degrees * (sine == 0 && cosine == 0 ? std::atan2(1, 0) : std::atan2(sine, cosine));
}

// The angle of section 3 between a face's outward normal and the line to it from the cell's centre.
// It should be less than 90 degrees for boundary faces and less than 75 for inner ones.
inline double faceAngle(const CellGeometry& cell, const FaceGeometry& face)
{
  return angle(minus(face.centre, cell.centre), face.area);
}

}
