// SPDX-License-Identifier: BSD-3-Clause
#include "OpenBodies.h"

#include "Base/Error.h"
#include "Lattice/Vector.h"

#include <cmath>

namespace cartesian
{

namespace
{

// The solid angle of a triangle seen from a place, of all around it; signed.
double partOfView(std::array<Vector, 3> corners, const Vector& place)
{
  std::array<double, 3> lengths;
  for (std::size_t i = 0; i < 3; ++i)
  {
    corners[i] = minus(corners[i], place);
    lengths[i] = norm(corners[i]);
  }
  const auto& [a, b, c] = corners;
  const double above = dot(a, cross(b, c));
  const double below = lengths[0] * lengths[1] * lengths[2] + dot(a, b) * lengths[2] +
    dot(b, c) * lengths[0] + dot(c, a) * lengths[1];
  return std::atan2(above, below) / (2 * std::acos(-1.0));
}

}

void LeftOutBodies::add(std::int32_t boundary, const std::array<Vector, 3>& triangle)
{
  const auto [part, isNew] = parts_.emplace(boundary, Part());
  if (isNew)
  {
    part->second.place = scaled(plus(plus(triangle[0], triangle[1]), triangle[2]), 1.0 / 3);
  }
  part->second.area +=
    norm(cross(minus(triangle[1], triangle[0]), minus(triangle[2], triangle[0]))) / 2;
}

std::string LeftOutBodies::describe(const BoundaryNames& names) const
{
  constexpr std::size_t MostPlaces = 5;
  if (parts_.empty())
  {
    return "";
  }
  std::string text = "Open bodies enclose nothing, and are left out beside solids. Export them as "
                     "solids if they should; the Boundary Type baffle of Cartesian Mesher makes "
                     "sheets of them:";
  std::size_t told = 0;
  for (const auto& [boundary, part] : parts_)
  {
    if (++told > MostPlaces)
    {
      return text + "\n  ...";
    }
    const Vector& p = part.place;
    text += "\n  area " + number(part.area) + ", of boundary " + names.at(boundary) + ", near (" +
      number(p[0]) + ", " + number(p[1]) + ", " + number(p[2]) + ")";
  }
  return text;
}

std::int32_t regionAround(
  const SurfaceView& surface, const std::vector<std::uint8_t>& isOpen, const Vector& place)
{
  std::map<std::int32_t, double> turns;
  for (std::size_t t = 0; t < surface.triangleCount; ++t)
  {
    if (isOpen[t] == 0)
    {
      turns[surface.region[t]] += partOfView(surface.corners(t), place);
    }
  }
  for (const auto& [region, around] : turns)
  {
    if (std::abs(around) > 0.5)
    {
      return region;
    }
  }
  return turns.begin()->first;
}

}
