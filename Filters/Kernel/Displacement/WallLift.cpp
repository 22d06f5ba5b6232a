// SPDX-License-Identifier: BSD-3-Clause
#include "Displacement/WallLift.h"

#include <algorithm>
#include <limits>

namespace cartesian
{

namespace
{

// What is nearer to the wall has no layers.
constexpr double LeastHeight = 4; // levels
constexpr double LeastPart = 0.1; // of the thickness

Vector asVector(const Point& p)
{
  return { double(p[0]), double(p[1]), double(p[2]) };
}

// A point of a triangle by its weights of the corners.
struct Place
{
  Vector weights{};
  double distance = std::numeric_limits<double>::infinity(); // from the point that was asked for
  std::uint32_t triangle = WallLift::NoTriangle;

  bool operator<(const Place& other) const
  {
    return distance != other.distance ? distance < other.distance : triangle < other.triangle;
  }
};

Vector weighted(const std::array<Vector, 3>& c, const Vector& w)
{
  return plus(plus(scaled(c[0], w[0]), scaled(c[1], w[1])), scaled(c[2], w[2]));
}

Vector onEdge(const std::array<Vector, 3>& c, std::size_t i, const Vector& p)
{
  const std::size_t j = (i + 1) % 3;
  const Vector along = minus(c[j], c[i]);
  const double square = dot(along, along);
  const double t = square > 0 ? std::clamp(dot(minus(p, c[i]), along) / square, 0.0, 1.0) : 0.0;
  Vector weights{};
  weights[i] = 1 - t;
  weights[j] = t;
  return weights;
}

Place nearestPlace(const std::array<Vector, 3>& c, const Vector& p, std::uint32_t triangle)
{
  Place best;
  const auto consider = [&](const Vector& weights) {
    const Place place{ weights, norm(minus(weighted(c, weights), p)), triangle };
    best = place.distance < best.distance ? place : best;
  };
  const Vector normal = cross(minus(c[1], c[0]), minus(c[2], c[0]));
  const double square = dot(normal, normal);
  Vector inside{};
  for (std::size_t i = 0; i < 3; ++i)
  {
    const Vector& next = c[(i + 1) % 3];
    inside[i] = dot(cross(minus(c[(i + 2) % 3], next), minus(p, next)), normal) / square;
    consider(onEdge(c, i, p));
  }
  if (inside[0] >= 0 && inside[1] >= 0 && inside[2] >= 0)
  {
    consider(inside);
  }
  return best;
}

}

class WallLift::Search
{
public:
  Search(const WallLift& lift, const Vector& at)
    : lift_(lift)
    , at_(at)
  {
  }

  Place find() const
  {
    Place best;
    for (double reach = LeastHeight; best.distance > reach && reach < 8 * LevelsOfTheDomain;
         reach *= 8)
    {
      const Vector r{ reach, reach, reach };
      lift_.tree_.forEachWithin(minus(at_, r), plus(at_, r), [&](std::uint32_t t) {
        if (lift_.displacement_.hasLayers(lift_.surface_.boundary[t]))
        {
          const Corners c = lift_.surface_.corners(t);
          const Place place =
            nearestPlace({ asVector(c[0]), asVector(c[1]), asVector(c[2]) }, at_, t);
          best = place < best ? place : best;
        }
      });
    }
    return best;
  }

private:
  const WallLift& lift_;
  const Vector at_;
};

WallLift::WallLift(const Surface& displaced, const Displacement& displacement, Execution& execution)
  : surface_(displaced)
  , displacement_(displacement)
  , tree_(displaced, execution)
{
}

Vector WallLift::operator()(const Vector& at) const
{
  const Place place = Search(*this, at).find();
  if (place.triangle == NoTriangle)
  {
    return at;
  }
  const auto& t = surface_.triangles[place.triangle];
  const auto& original = displacement_.original;
  const Corners c = surface_.corners(place.triangle);
  const std::array<Vector, 3> way{ minus(original[t[0]], c[0]), minus(original[t[1]], c[1]),
    minus(original[t[2]], c[2]) };
  return plus(at, weighted(way, place.weights));
}

std::uint32_t WallLift::triangleAt(const Vector& at) const
{
  return Search(*this, at).find().triangle;
}

bool WallLift::hasRoom(const Vector& from, const Vector& to) const
{
  return norm(minus(to, from)) > std::max(LeastHeight, LeastPart * displacement_.thickness);
}

}
