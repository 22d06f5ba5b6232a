// Centres, areas and volumes of polygons and polyhedra as OpenFOAM computes them, and the angles of
// section 3. Any unit of length.
#pragma once

#include "Vector.h"

namespace cartesian
{

// Below this, areas and volumes count as nothing: only a divisor is kept from 0.
constexpr double Tiny = 1e-150;

struct FaceGeometry
{
  Vector centre; // mean of the star triangles' centres, weighted with their areas
  Vector area;   // sum of the star triangles' (equation 1); counter-clockwise is positive
  double star;   // the smallest star triangle, as a part of the mean one; negative: turned over
};

// A face of `size` corners, corner(i); its star triangulation is about the mean of the corners.
template <class Corner>
FaceGeometry measureFace(std::size_t size, Corner&& corner)
{
  const Vector origin = corner(0); // all sums are taken from here, for accuracy
  Vector mean{ 0, 0, 0 };
  for (std::size_t i = 0; i < size; ++i)
  {
    mean = plus(mean, minus(corner(i), origin));
  }
  mean = scaled(mean, 1.0 / static_cast<double>(size));
  const auto triangle = [&](std::size_t i, Vector& p, Vector& q) {
    p = minus(corner(i), origin);
    q = minus(corner(i + 1 < size ? i + 1 : 0), origin);
    return scaled(cross(minus(p, mean), minus(q, mean)), 0.5);
  };
  Vector p;
  Vector q;
  FaceGeometry face{ { 0, 0, 0 }, { 0, 0, 0 }, 1 };
  double sum = 0;
  for (std::size_t i = 0; i < size; ++i)
  {
    const Vector area = triangle(i, p, q);
    face.area = plus(face.area, area);
    sum += norm(area);
    face.centre = plus(face.centre, scaled(plus(mean, plus(p, q)), norm(area) / 3));
  }
  face.centre = plus(origin, sum < Tiny ? mean : scaled(face.centre, 1 / sum));
  for (std::size_t i = 0; size > 3 && i < size; ++i)
  {
    const double part = dot(triangle(i, p, q), face.area) * static_cast<double>(size);
    face.star = std::min(face.star, part / (dot(face.area, face.area) + Tiny));
  }
  return face;
}

struct CellGeometry
{
  Vector centre; // of gravity, of the pyramids from the mean of the face centres
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

// In degrees, 0 to 180; 90 where one of them is 0.
inline double angle(const Vector& u, const Vector& v)
{
  constexpr double Degrees = 57.29577951308232;
  const double sine = norm(cross(u, v));
  const double cosine = dot(u, v);
  return Degrees * (sine == 0 && cosine == 0 ? std::atan2(1, 0) : std::atan2(sine, cosine));
}

// The angle of section 3 between the face's outward normal and the way to it from the cell's
// centre: less than 90 degrees for boundary faces, less than 75 for inner ones.
inline double faceAngle(const CellGeometry& cell, const FaceGeometry& face)
{
  return angle(minus(face.centre, cell.centre), face.area);
}

}
