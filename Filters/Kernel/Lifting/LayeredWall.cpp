// SPDX-License-Identifier: BSD-3-Clause
#include "Lifting/LayeredWall.h"

#include <algorithm>
#include <limits>

namespace cartesian
{

namespace
{

constexpr std::size_t NodesAChunk = 256;
// Nodes nearer to the wall have no layers.
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
  std::uint32_t triangle = None;

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

class WallFinder
{
public:
  WallFinder(const OutputMesh& mesh, const std::vector<double>& points, const Surface& displaced,
    const Displacement& displacement, Execution& execution)
    : mesh_(mesh)
    , surface_(displaced)
    , displacement_(displacement)
    , execution_(execution)
    , tree_(displaced, execution)
  {
    wall_.faces = mesh.boundaryMesh(execution);
    for (const Id point : wall_.faces.meshPoint)
    {
      const double* const at = &points[3 * static_cast<std::size_t>(point)];
      wall_.displaced.push_back({ at[0], at[1], at[2] });
    }
  }

  LayeredWall run()
  {
    const std::size_t nodes = wall_.displaced.size();
    findLayered();
    wall_.onWall = wall_.displaced;
    wall_.parts.assign(nodes, 0);
    execution_.forEach(nodes, NodesAChunk, [&](std::size_t begin, std::size_t end) {
      for (std::size_t n = begin; n < end; ++n)
      {
        if (wall_.isOnWall[n])
        {
          lift(n);
        }
      }
    });
    return std::move(wall_);
  }

private:
  void findLayered()
  {
    wall_.layered.resize(mesh_.boundary().size());
    wall_.isOnWall.assign(wall_.faces.meshPoint.size(), 0);
    for (std::size_t f = 0; f < wall_.layered.size(); ++f)
    {
      wall_.layered[f] = displacement_.hasLayers(mesh_.boundary()[f].boundary);
      for (std::size_t i = 0; wall_.layered[f] && i < wall_.corners(f); ++i)
      {
        wall_.isOnWall[wall_.node(f, i)] = 1;
      }
    }
  }

  Place find(const Vector& at) const
  {
    Place best;
    for (double reach = LeastHeight; best.distance > reach && reach < LevelsOfTheDomain; reach *= 8)
    {
      const Vector r{ reach, reach, reach };
      tree_.forEachWithin(minus(at, r), plus(at, r), [&](std::uint32_t t) {
        if (displacement_.hasLayers(surface_.boundary[t]))
        {
          const Corners c = surface_.corners(t);
          const Place place =
            nearestPlace({ asVector(c[0]), asVector(c[1]), asVector(c[2]) }, at, t);
          best = place < best ? place : best;
        }
      });
    }
    return best;
  }

  void lift(std::size_t n)
  {
    const Lattice& lattice = surface_.lattice;
    const Vector at = scaled(minus(wall_.displaced[n], lattice.origin()), 1 / lattice.step());
    const Place place = find(at);
    if (place.triangle == None)
    {
      return;
    }
    const auto& t = surface_.triangles[place.triangle];
    const auto& original = displacement_.original;
    const Vector to = weighted(
      { asVector(original[t[0]]), asVector(original[t[1]]), asVector(original[t[2]]) },
      place.weights);
    const double height = norm(minus(to, at));
    wall_.parts[n] = height > std::max(LeastHeight, LeastPart * displacement_.thickness) ? 1 : 0;
    wall_.onWall[n] = plus(lattice.origin(), scaled(to, lattice.step()));
  }

  const OutputMesh& mesh_;
  const Surface& surface_;
  const Displacement& displacement_;
  Execution& execution_;
  const TriangleTree tree_;
  LayeredWall wall_;
};

}

bool LayeredWall::hasStack(std::size_t face) const
{
  bool any = false;
  for (std::size_t i = 0; i < corners(face); ++i)
  {
    any = any || parts[node(face, i)] > 0;
  }
  return layered[face] && any;
}

LayeredWall findLayeredWall(const OutputMesh& mesh, const std::vector<double>& points,
  const Surface& displaced, const Displacement& displacement, Execution& execution)
{
  return WallFinder(mesh, points, displaced, displacement, execution).run();
}

}
