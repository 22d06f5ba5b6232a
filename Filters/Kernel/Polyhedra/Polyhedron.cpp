// SPDX-License-Identifier: BSD-3-Clause
#include "Polyhedra/Polyhedron.h"

#include <algorithm>
#include <cmath>

namespace cartesian
{

namespace
{

constexpr double LeastThickness = 4; // levels

template <class Corner>
Vector meanOf(std::size_t size, Corner&& corner)
{
  Vector mean{ 0, 0, 0 };
  for (std::size_t i = 0; i < size; ++i)
  {
    mean = plus(mean, corner(i));
  }
  return scaled(mean, 1.0 / static_cast<double>(size));
}

}

FaceShape measure(const Ring& ring)
{
  const auto corner = [&](std::size_t i) -> const Vector& { return ring[i]; };
  const FaceGeometry geometry = measureFace(ring.size, corner);
  return { geometry.area, geometry.centre, meanOf(ring.size, corner) };
}

// The same bits as measureFace's.
Vector areaOf(const Ring& ring)
{
  if (ring.size == 3)
  {
    return scaled(cross(minus(ring[1], ring[0]), minus(ring[2], ring[0])), 0.5);
  }
  Vector area{ 0, 0, 0 };
  forEachStarTriangle(
    ring.size, [&](std::size_t i) -> const Vector& { return ring[i]; },
    [&](const Vector&, const Vector&, const Vector& triangle) { area = plus(area, triangle); });
  return area;
}

void measureVolume(CellShape& shape)
{
  Vector middle{ 0, 0, 0 };
  for (const FaceShape& face : shape.faces)
  {
    middle = plus(middle, face.centre);
  }
  middle = scaled(middle, 1.0 / static_cast<double>(shape.faces.size()));
  shape.volume = 0;
  double pyramids = 0;
  Vector moment{ 0, 0, 0 };
  for (const FaceShape& face : shape.faces)
  {
    const Vector height = minus(face.centre, middle);
    const double volume = dot(face.area, height) / 3;
    pyramids += volume;
    moment = plus(moment, scaled(height, 0.75 * volume));
    shape.volume += dot(face.area, minus(face.mean, middle)) / 3;
  }
  shape.centre = pyramids > 0 ? plus(middle, scaled(moment, 1 / pyramids)) : middle;
}

void Polyhedron::clear()
{
  nodes.clear();
  start.assign(1, 0);
  corners.clear();
  isBoundary.clear();
}

void Polyhedron::reserve(std::size_t ofNodes, std::size_t ofFaces, std::size_t ofCorners)
{
  nodes.reserve(ofNodes);
  start.reserve(ofFaces + 1);
  corners.reserve(ofCorners);
  isBoundary.reserve(ofFaces);
}

void measure(const Polyhedron& cell, CellShape& shape)
{
  shape.faces.resize(cell.faces());
  for (std::size_t f = 0; f < cell.faces(); ++f)
  {
    shape.faces[f] = measure(ringOf(cell, f));
  }
  measureVolume(shape);
}

void projectCentres(const Polyhedron& cell, CellShape& shape)
{
  for (std::size_t f = 0; f < cell.faces(); ++f)
  {
    const Ring ring = ringOf(cell, f);
    shape.faces[f].centre = projectedCentre(
      ring.size, [&](std::size_t i) -> const Vector& { return ring[i]; }, shape.faces[f].area);
  }
  measureVolume(shape);
}

bool isThin(const CellShape& shape)
{
  double area = 0;
  for (const FaceShape& face : shape.faces)
  {
    area += norm(face.area);
  }
  return shape.volume <= LeastThickness * area;
}

bool isFlat(const Ring& ring, const FaceShape& shape, double distance)
{
  const Vector normal = unit(shape.area);
  for (std::size_t i = 0; i < ring.size; ++i)
  {
    if (std::abs(dot(minus(ring[i], shape.centre), normal)) > distance)
    {
      return false;
    }
  }
  return true;
}

bool isStar(const Ring& ring, const Vector& normal)
{
  const Vector mean = meanOf(ring.size, [&](std::size_t i) -> const Vector& { return ring[i]; });
  double least = 0;
  double sum = 0;
  for (std::size_t i = 0; i < ring.size; ++i)
  {
    const Vector p = minus(ring[i], mean);
    const Vector q = minus(ring[i + 1 < ring.size ? i + 1 : 0], mean);
    const double area = dot(cross(p, q), normal);
    least = std::min(least, area);
    sum += area;
  }
  return least >= -StarRounding * std::abs(sum);
}

}
