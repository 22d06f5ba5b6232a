// SPDX-License-Identifier: BSD-3-Clause
// Centres, areas and volumes of polygons and polyhedra as OpenFOAM computes them, and the angles of
// section 3. Works in any unit of length, with doubles or with numbers that know more, such as their gradients.
#pragma once

#include "Lattice/Vector.h"

#include <algorithm>
#include <cstdint>
#include <type_traits>

namespace cartesian
{

// Smaller areas and volumes count as zero; this only keeps divisors from vanishing.
constexpr double Tiny = 1e-150;

template <class Number>
using VectorOf = std::array<Number, 3>;

inline double valueOf(double x)
{
  return x;
}

// The numbers of what corner(i), or face(i), gives.
template <class Function>
using AtIndex = std::decay_t<std::invoke_result_t<Function&, std::size_t>>;
template <class Corner>
using NumberOf = typename AtIndex<Corner>::value_type;

template <class Number>
struct FaceGeometryOf
{
  VectorOf<Number> centre; // area-weighted mean of the star triangles' centres
  VectorOf<Number>
    area; // sum of the star triangles' area vectors (equation 1), positive counter-clockwise
};

using FaceGeometry = FaceGeometryOf<double>;

// Calls visit(p, q, area) for the star triangles around the mean of a face's corners, corner(0) to
// corner(size - 1): two corners relative to the mean, and the triangle's area vector. Returns the
// mean.
template <class Corner, class Visitor>
VectorOf<NumberOf<Corner>> forEachStarTriangle(std::size_t size, Corner&& corner, Visitor&& visit)
{
  using Vectors = VectorOf<NumberOf<Corner>>;
  const Vectors origin = corner(0); // sums are relative to this, for accuracy
  Vectors mean{};
  for (std::size_t i = 1; i < size; ++i)
  {
    mean = plus(mean, minus(corner(i), origin));
  }
  mean = plus(origin, scaled(mean, 1.0 / static_cast<double>(size)));
  Vectors p = minus(corner(size - 1), mean);
  for (std::size_t i = 0; i < size; ++i)
  {
    const Vectors q = minus(corner(i), mean);
    visit(p, q, scaled(cross(p, q), 0.5));
    p = q;
  }
  return mean;
}

// What the star triangles of a face enclose with the origin.
struct Cone
{
  Vector area;
  double volume; // positive if the face is seen from behind
};

template <class Corner>
Cone measureCone(std::size_t size, Corner&& corner)
{
  Vector area{};
  const Vector mean = forEachStarTriangle(size, corner,
    [&](const Vector&, const Vector&, const Vector& triangle) { area = plus(area, triangle); });
  return { area, dot(mean, area) / 3 };
}

// Sums over the triangles of a star.
template <class Number>
struct StarSums
{
  VectorOf<Number> mean; // of the corners
  VectorOf<Number> area{};
  VectorOf<Number> moment{};
  Number size = Number(0); // of the triangles' areas

  FaceGeometryOf<Number> geometry() const
  {
    return { valueOf(size) > Tiny ? plus(mean, scaled(moment, Number(1) / size)) : mean, area };
  }
};

// Calls visit(area) for the triangles.
template <class Corner, class Visitor>
StarSums<NumberOf<Corner>> sumStar(std::size_t size, Corner&& corner, Visitor&& visit)
{
  using Number = NumberOf<Corner>;
  using Vectors = VectorOf<Number>;
  StarSums<Number> sums;
  sums.mean = forEachStarTriangle(
    size, corner, [&](const Vectors& p, const Vectors& q, const Vectors& triangle) {
      const Number part = norm(triangle);
      sums.area = plus(sums.area, triangle);
      sums.moment = plus(sums.moment, scaled(plus(p, q), part * (1.0 / 3)));
      sums.size += part;
      visit(triangle);
    });
  return sums;
}

template <class Corner>
FaceGeometryOf<NumberOf<Corner>> measureTriangle(Corner&& corner)
{
  const VectorOf<NumberOf<Corner>> origin = corner(0);
  const VectorOf<NumberOf<Corner>> p = minus(corner(1), origin);
  const VectorOf<NumberOf<Corner>> q = minus(corner(2), origin);
  return { plus(origin, scaled(plus(p, q), 1.0 / 3)), scaled(cross(p, q), 0.5) };
}

template <class Corner>
FaceGeometryOf<NumberOf<Corner>> measureFace(std::size_t size, Corner&& corner)
{
  return size == 3 ? measureTriangle(corner) : sumStar(size, corner, [](const auto&) {}).geometry();
}

template <class Number>
struct CellGeometryOf
{
  VectorOf<Number>
    centre; // of mass, from the pyramids between the faces and the mean of their centres
  Number volume;
};

using CellGeometry = CellGeometryOf<double>;

// A cell of `size` faces, face(i), with outward areas.
template <class Face>
auto measureCell(std::size_t size, Face&& face)
{
  using Number = typename decltype(AtIndex<Face>::centre)::value_type;
  VectorOf<Number> mean{};
  for (std::size_t i = 0; i < size; ++i)
  {
    mean = plus(mean, face(i).centre);
  }
  mean = scaled(mean, 1.0 / static_cast<double>(std::max<std::size_t>(size, 1)));
  VectorOf<Number> moment{};
  Number volume(0);
  for (std::size_t i = 0; i < size; ++i)
  {
    const auto& f = face(i);
    const VectorOf<Number> height = minus(f.centre, mean);
    const Number product = dot(f.area, height);
    volume += product * (1.0 / 3);
    moment = plus(moment, scaled(height, product * 0.25));
  }
  return CellGeometryOf<Number>{
    std::abs(valueOf(volume)) < Tiny ? mean : plus(mean, scaled(moment, Number(1) / volume)), volume
  };
}

// Of the pyramid on a face, which has a centre and an area; negative if that looks at the apex.
template <class Face>
double pyramidVolume(const Face& face, const Vector& apex)
{
  return dot(face.area, minus(face.centre, apex)) / 3;
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
