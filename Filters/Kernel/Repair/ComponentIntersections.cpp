// SPDX-License-Identifier: BSD-3-Clause
#include "Repair/ComponentIntersections.h"

#include "Base/Rings.h"
#include "Lattice/Vector.h"
#include "Repair/Snapping.h"

#include <algorithm>

namespace cartesian
{

namespace
{

double distanceToEdges(const Corners& corners, const Vector& place)
{
  double least = std::numeric_limits<double>::max();
  for (std::size_t i = 0; i < 3; ++i)
  {
    const Vector along = unit(minus(following(corners, i), corners[i]));
    least = std::min(least, norm(cross(along, minus(place, toVector(corners[i])))));
  }
  return least;
}

// How far a triangle reaches behind the plane of another and in front of it, where what both share runs through the
// other's middle; else not at all. In levels, the first negative.
std::array<double, 2> reachOf(const Corners& triangle, const Corners& other, double snap)
{
  const auto [from, to] = sharedSegment(triangle, other);
  std::array<double, 2> reach{ 0, 0 };
  if (distanceToEdges(other, scaled(plus(from, to), 0.5)) < snap)
  {
    return reach;
  }
  const Vector normal = unit(cross(minus(other[1], other[0]), minus(other[2], other[0])));
  for (const Point& corner : triangle)
  {
    const double height = dot(normal, minus(corner, other[0]));
    reach = { std::min(reach[0], height), std::max(reach[1], height) };
  }
  return reach;
}

}

ComponentIntersections::ComponentIntersections(const Surface& surface,
  const ManifoldComponents& sheets, const std::vector<TrianglePair>& pairs,
  const std::vector<double>& volume)
{
  const double snap = placingOf(surface).snap;
  for (const TrianglePair& pair : pairs)
  {
    const std::uint32_t ofFirst = sheets.of(pair.first);
    const std::uint32_t ofSecond = sheets.of(pair.second);
    if (pair.contact != Contact::Crossing || ofFirst == ofSecond || !sheets.closed(ofFirst) ||
      !sheets.closed(ofSecond))
    {
      continue;
    }
    for (const auto& [t, other] : { std::array<std::uint32_t, 2>{ pair.first, pair.second },
           std::array<std::uint32_t, 2>{ pair.second, pair.first } })
    {
      const std::uint32_t sheet = sheets.of(other);
      const auto [behind, front] = reachOf(surface.corners(t), surface.corners(other), snap);
      const bool facesOut = sheets.turned(other) == (volume[sheet] < 0);
      std::uint8_t& sides = sides_[{ sheets.of(t), sheet }];
      sides |= behind < -snap ? (facesOut ? Inside : Outside) : 0;
      sides |= front > snap ? (facesOut ? Outside : Inside) : 0;
    }
  }
}

std::uint8_t ComponentIntersections::sidesOf(std::uint32_t a, std::uint32_t b) const
{
  const auto found = sides_.find({ a, b });
  return found == sides_.end() ? 0 : found->second;
}

bool ComponentIntersections::cross(std::uint32_t a, std::uint32_t b) const
{
  const std::uint8_t ofA = sidesOf(a, b);
  const std::uint8_t ofB = sidesOf(b, a);
  return ofA == Both || ofB == Both || (ofA & ofB & Inside) != 0;
}

bool ComponentIntersections::meet(std::uint32_t a, std::uint32_t b) const
{
  return sides_.count({ a, b }) != 0;
}

}
