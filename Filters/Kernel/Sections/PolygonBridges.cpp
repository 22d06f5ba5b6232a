// SPDX-License-Identifier: BSD-3-Clause
#include "Sections/PolygonBridges.h"

#include "Base/Rings.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

namespace cartesian
{

namespace
{

using Place = std::array<double, 2>;
using Ring = std::vector<Place>;

double turn(const Place& a, const Place& b, const Place& c)
{
  return (b[0] - a[0]) * (c[1] - a[1]) - (b[1] - a[1]) * (c[0] - a[0]);
}

double areaOf(const Ring& ring)
{
  double twice = 0;
  for (std::size_t i = 1; i + 1 < ring.size(); ++i)
  {
    twice += turn(ring[0], ring[i], ring[i + 1]);
  }
  return twice / 2;
}

bool contains(const Ring& ring, const Place& p)
{
  bool inside = false;
  for (std::size_t i = 0; i < ring.size(); ++i)
  {
    const Place& a = ring[i];
    const Place& b = following(ring, i);
    if ((a[1] > p[1]) != (b[1] > p[1]) && (turn(a, b, p) > 0) == (b[1] > a[1]))
    {
      inside = !inside;
    }
  }
  return inside;
}

bool cross(const Place& a, const Place& b, const Place& c, const Place& d)
{
  return turn(a, b, c) * turn(a, b, d) < 0 && turn(c, d, a) * turn(c, d, b) < 0;
}

class Bridging
{
public:
  Bridging(const std::vector<std::vector<Vector>>& rings, const Vector& normal)
  {
    const Vector n = unit(normal);
    const Vector other = std::abs(n[0]) < 0.5 ? Vector{ 1, 0, 0 } : Vector{ 0, 1, 0 };
    const Vector u = unit(cartesian::cross(other, n));
    const Vector v = cartesian::cross(n, u);
    const Vector& origin = rings.front().front();
    for (const std::vector<Vector>& ring : rings)
    {
      rings_.emplace_back();
      for (const Vector& corner : ring)
      {
        const Vector from = minus(corner, origin);
        rings_.back().push_back({ dot(from, u), dot(from, v) });
      }
    }
  }

  std::vector<Bridged> find()
  {
    std::vector<Bridged> polygons;
    std::vector<std::vector<std::size_t>> holes;
    for (std::size_t ring = 0; ring < rings_.size(); ++ring)
    {
      if (areaOf(rings_[ring]) >= 0)
      {
        polygons.push_back(whole(ring, 0));
      }
    }
    holes.resize(polygons.size());
    for (std::size_t ring = 0; ring < rings_.size(); ++ring)
    {
      if (areaOf(rings_[ring]) < 0)
      {
        const std::size_t around = polygonAround(ring, polygons);
        if (around < polygons.size())
        {
          holes[around].push_back(ring);
        }
      }
    }
    for (std::size_t polygon = 0; polygon < polygons.size(); ++polygon)
    {
      for (const std::size_t hole : holes[polygon])
      {
        join(hole, holes[polygon], polygons[polygon]);
      }
    }
    return polygons;
  }

private:
  Bridged whole(std::size_t ring, std::size_t first) const
  {
    Bridged corners;
    for (std::size_t i = 0; i < rings_[ring].size(); ++i)
    {
      corners.emplace_back(ring, (first + i) % rings_[ring].size());
    }
    return corners;
  }

  // The smallest that contains it.
  std::size_t polygonAround(std::size_t hole, const std::vector<Bridged>& polygons) const
  {
    std::size_t found = polygons.size();
    double least = std::numeric_limits<double>::infinity();
    for (std::size_t i = 0; i < polygons.size(); ++i)
    {
      const Ring& ring = rings_[polygons[i].front().first];
      const double area = areaOf(ring);
      if (area < least && contains(ring, rings_[hole].front()))
      {
        found = i;
        least = area;
      }
    }
    return found;
  }

  const Place& at(const std::pair<std::size_t, std::size_t>& corner) const
  {
    return rings_[corner.first][corner.second];
  }

  // By the shortest bridge that crosses nothing.
  void join(std::size_t hole, const std::vector<std::size_t>& holes, Bridged& polygon) const
  {
    std::size_t from = 0;
    std::size_t to = 0;
    double least = std::numeric_limits<double>::infinity();
    for (std::size_t i = 0; i < polygon.size(); ++i)
    {
      for (std::size_t j = 0; j < rings_[hole].size(); ++j)
      {
        const Place& a = at(polygon[i]);
        const Place& b = rings_[hole][j];
        const double length = std::hypot(b[0] - a[0], b[1] - a[1]);
        if (length < least && isFree(a, b, polygon, holes))
        {
          least = length;
          from = i;
          to = j;
        }
      }
    }
    Bridged bridge = whole(hole, to);
    bridge.emplace_back(hole, to);
    bridge.push_back(polygon[from]);
    polygon.insert(
      polygon.begin() + static_cast<std::ptrdiff_t>(from) + 1, bridge.begin(), bridge.end());
  }

  bool isFree(const Place& a, const Place& b, const Bridged& polygon,
    const std::vector<std::size_t>& holes) const
  {
    for (std::size_t i = 0; i < polygon.size(); ++i)
    {
      if (cross(a, b, at(polygon[i]), at(following(polygon, i))))
      {
        return false;
      }
    }
    return std::none_of(holes.begin(), holes.end(), [&](std::size_t hole) {
      const Ring& ring = rings_[hole];
      for (std::size_t i = 0; i < ring.size(); ++i)
      {
        if (cross(a, b, ring[i], following(ring, i)))
        {
          return true;
        }
      }
      return false;
    });
  }

  std::vector<Ring> rings_;
};

}

std::vector<Bridged> bridgeHoles(
  const std::vector<std::vector<Vector>>& rings, const Vector& normal)
{
  return Bridging(rings, normal).find();
}

}
