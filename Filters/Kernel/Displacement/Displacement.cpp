// SPDX-License-Identifier: BSD-3-Clause
#include "Displacement/Displacement.h"

#include "Base/Sorting.h"
#include "Repair/TrianglePairs.h"

#include <algorithm>
#include <cmath>

namespace cartesian
{

namespace
{

constexpr double LongestMitre = 2;       // in thicknesses
constexpr double PartOfTheWay = 1.0 / 3; // to what lies opposite
constexpr double Slope = 0.5;            // of the thickness, along an edge
constexpr double LeastCosine = 0.5;      // between a triangle's normals before and after
constexpr double SinOfOnePlane = 0.05;   // normals that differ by less are of one facet
constexpr double Damping = 1e-3;         // of the directions that facets hardly determine
constexpr int DampedSteps = 8;           // until what they do determine is exact to rounding
constexpr int HalvingRounds = 5;
constexpr int MostRounds = 20;

using Matrix = std::array<Vector, 3>;

Vector solve(const Matrix& m, const Vector& right)
{
  const double determinant = dot(m[0], cross(m[1], m[2]));
  const Vector sum =
    plus(plus(scaled(cross(m[1], m[2]), right[0]), scaled(cross(m[2], m[0]), right[1])),
      scaled(cross(m[0], m[1]), right[2]));
  return scaled(sum, 1 / determinant);
}

struct Facet
{
  Vector normal; // inwards
  double angle;  // at the vertex
};

// The facets around a vertex: triangles in one plane count once, with all their angle.
void addFacet(std::vector<Facet>& facets, const Vector& normal, double angle)
{
  for (Facet& facet : facets)
  {
    if (dot(facet.normal, normal) > 0 && norm(cross(facet.normal, normal)) < SinOfOnePlane)
    {
      facet.normal = unit(plus(scaled(facet.normal, facet.angle), scaled(normal, angle)));
      facet.angle += angle;
      return;
    }
  }
  facets.push_back({ normal, angle });
}

// What is left of a vector within the planes.
Vector within(const std::vector<Vector>& planes, Vector v)
{
  for (const Vector& normal : planes)
  {
    v = minus(v, scaled(normal, dot(v, normal)));
  }
  return v;
}

// Where the facets' planes, displaced by 1, meet: least squares, within the planes of boundaries without
// layers.
Vector meetingPoint(const std::vector<Facet>& facets, const std::vector<Facet>& others)
{
  std::vector<Vector> planes; // orthonormal
  for (const Facet& other : others)
  {
    const Vector rest = within(planes, other.normal);
    if (norm(rest) > 2 * SinOfOnePlane && planes.size() < 3)
    {
      planes.push_back(unit(rest));
    }
  }
  Matrix squares{};
  Vector sum{};
  double angles = 0;
  for (const Facet& facet : facets)
  {
    const Vector normal = within(planes, facet.normal);
    for (std::size_t i = 0; i < 3; ++i)
    {
      squares[i] = plus(squares[i], scaled(normal, facet.angle * normal[i]));
    }
    sum = plus(sum, scaled(normal, facet.angle));
    angles += facet.angle;
  }
  for (std::size_t i = 0; i < 3; ++i)
  {
    squares[i][i] += Damping * angles;
  }
  Vector at = unit(sum);
  for (int step = 0; step < DampedSteps && angles > 0; ++step)
  {
    at = solve(squares, plus(sum, scaled(at, Damping * angles)));
  }
  return norm(at) > LongestMitre ? scaled(unit(at), LongestMitre) : at;
}

double angleAt(const Corners& c, int i)
{
  const Vector u = unit(minus(c[(i + 1) % 3], c[i]));
  const Vector v = unit(minus(c[(i + 2) % 3], c[i]));
  return std::acos(std::clamp(dot(u, v), -1.0, 1.0));
}

Vector normalOf(const std::array<Vector, 3>& c)
{
  return cross(minus(c[1], c[0]), minus(c[2], c[0]));
}

Vector asVector(const Point& p)
{
  return { double(p[0]), double(p[1]), double(p[2]) };
}

Level oddLevel(double level)
{
  return static_cast<Level>(2 * std::floor(level / 2) + 1);
}

// Where a segment meets a triangle, from 0 to 1 along it; more than 1: nowhere.
double meet(const Vector& from, const Vector& along, const std::array<Vector, 3>& triangle)
{
  const Vector u = minus(triangle[1], triangle[0]);
  const Vector v = minus(triangle[2], triangle[0]);
  const Vector w = cross(along, v);
  const double determinant = dot(u, w);
  const Vector start = minus(from, triangle[0]);
  const double a = dot(start, w) / determinant;
  const Vector x = cross(start, u);
  const double b = dot(along, x) / determinant;
  const double t = dot(v, x) / determinant;
  constexpr double Rounding = 1e-9;
  const bool meets = a >= -Rounding && b >= -Rounding && a + b <= 1 + Rounding && t > 0;
  return meets ? t : 2; // NaN of parallels is no meeting
}

class Displacer
{
public:
  Displacer(Surface& surface, Displacement& result, double thickness, Execution& execution)
    : surface_(surface)
    , d_(result)
    , thickness_(thickness)
    , execution_(execution)
  {
    listTriangles();
  }

  void run()
  {
    findDirections();
    keepFromOpposite();
    settle();
  }

  void runAgain(std::vector<std::uint32_t> notAt, int rings)
  {
    for (int ring = 0; ring <= rings; ++ring)
    {
      std::vector<std::uint32_t> next;
      for (const std::uint32_t t : notAt)
      {
        for (const std::uint32_t v : surface_.triangles[t])
        {
          d_.parts[v] = 0;
          next.insert(next.end(), around_.begin() + std::ptrdiff_t(start_[v]),
            around_.begin() + std::ptrdiff_t(start_[v + 1]));
        }
      }
      std::sort(next.begin(), next.end());
      next.erase(std::unique(next.begin(), next.end()), next.end());
      notAt = std::move(next);
    }
    settle();
  }

private:
  void settle()
  {
    smooth();
    for (int round = 0; round < MostRounds; ++round)
    {
      move();
      const std::vector<std::uint8_t> failing = findFailing();
      if (std::find(failing.begin(), failing.end(), 1) == failing.end())
      {
        return;
      }
      for (std::size_t v = 0; v < failing.size(); ++v)
      {
        d_.parts[v] *= failing[v] ? (round < HalvingRounds ? 0.5 : 0.0) : 1.0;
      }
      smooth();
    }
    std::fill(d_.parts.begin(), d_.parts.end(), 0.0);
    move();
  }

  static constexpr std::size_t VerticesAChunk = 1 << 10;

  void listTriangles()
  {
    start_.assign(surface_.vertices.size() + 1, 0);
    for (const auto& triangle : surface_.triangles)
    {
      for (const std::uint32_t v : triangle)
      {
        ++start_[v];
      }
    }
    scan(start_);
    std::vector<std::size_t> next = start_;
    around_.resize(3 * surface_.triangles.size());
    for (std::size_t t = 0; t < surface_.triangles.size(); ++t)
    {
      for (const std::uint32_t v : surface_.triangles[t])
      {
        around_[next[v]++] = static_cast<std::uint32_t>(t);
      }
    }
  }

  template <class Visitor>
  void forEachVertex(Visitor&& visit)
  {
    execution_.forEach(
      surface_.vertices.size(), VerticesAChunk, [&](std::size_t begin, std::size_t end) {
        for (std::size_t v = begin; v < end; ++v)
        {
          visit(v);
        }
      });
  }

  std::array<Vector, 3> originalCorners(std::size_t t) const
  {
    const auto& triangle = surface_.triangles[t];
    return { asVector(d_.original[triangle[0]]), asVector(d_.original[triangle[1]]),
      asVector(d_.original[triangle[2]]) };
  }

  void findDirections()
  {
    d_.directions.assign(surface_.vertices.size(), Vector{});
    forEachVertex([&](std::size_t v) {
      std::vector<Facet> facets;
      std::vector<Facet> others;
      for (std::size_t i = start_[v]; i < start_[v + 1]; ++i)
      {
        const std::uint32_t t = around_[i];
        const auto& triangle = surface_.triangles[t];
        const auto at =
          static_cast<int>(std::find(triangle.begin(), triangle.end(), v) - triangle.begin());
        const Vector normal = unit(normalOf(originalCorners(t)));
        if (norm(normal) > 0)
        {
          addFacet(d_.hasLayers(surface_.boundary[t]) ? facets : others, scaled(normal, -1),
            angleAt(surface_.corners(t), at));
        }
      }
      d_.directions[v] = scaled(meetingPoint(facets, others), thickness_);
    });
    d_.parts.assign(surface_.vertices.size(), 1);
  }

  // A ray from each vertex.
  void keepFromOpposite()
  {
    const TriangleTree tree(surface_, execution_);
    forEachVertex([&](std::size_t v) {
      const Vector from = asVector(d_.original[v]);
      const Vector along = scaled(d_.directions[v], 1 / PartOfTheWay);
      if (norm(along) == 0)
      {
        return;
      }
      const Vector to = plus(from, along);
      double nearest = 1;
      tree.forEachWithin(lower(from, to), upper(from, to), [&](std::uint32_t t) {
        const auto& triangle = surface_.triangles[t];
        if (std::find(triangle.begin(), triangle.end(), v) == triangle.end())
        {
          nearest = std::min(nearest, meet(from, along, originalCorners(t)));
        }
      });
      d_.parts[v] = nearest;
    });
  }

  static Vector lower(const Vector& p, const Vector& q)
  {
    return { std::min(p[0], q[0]), std::min(p[1], q[1]), std::min(p[2], q[2]) };
  }
  static Vector upper(const Vector& p, const Vector& q)
  {
    return { std::max(p[0], q[0]), std::max(p[1], q[1]), std::max(p[2], q[2]) };
  }

  // Lowers parts until none is more above a neighbour's than the slope allows: the same whatever the
  // order.
  void smooth()
  {
    for (bool changed = true; changed;)
    {
      std::vector<double> next = d_.parts;
      forEachVertex([&](std::size_t v) {
        for (std::size_t i = start_[v]; i < start_[v + 1]; ++i)
        {
          for (const std::uint32_t other : surface_.triangles[around_[i]])
          {
            if (norm(d_.directions[other]) > 0)
            {
              const double length = norm(minus(d_.original[v], d_.original[other]));
              next[v] = std::min(next[v], d_.parts[other] + Slope * length / thickness_);
            }
          }
        }
      });
      changed = next != d_.parts;
      d_.parts = std::move(next);
    }
  }

  void move()
  {
    forEachVertex([&](std::size_t v) {
      surface_.vertices[v] = d_.original[v];
      for (std::size_t axis = 0; axis < 3; ++axis)
      {
        const double by = d_.parts[v] * d_.directions[v][axis];
        if (by != 0)
        {
          surface_.vertices[v][axis] = oddLevel(double(d_.original[v][axis]) + by);
        }
      }
    });
  }

  // The vertices of triangles that turned over, and of those that cross others.
  std::vector<std::uint8_t> findFailing()
  {
    std::vector<std::uint8_t> failing(surface_.vertices.size());
    const auto fail = [&](std::uint32_t t) {
      for (const std::uint32_t v : surface_.triangles[t])
      {
        failing[v] = d_.parts[v] > 0 && norm(d_.directions[v]) > 0;
      }
    };
    for (std::size_t t = 0; t < surface_.triangles.size(); ++t)
    {
      const Corners c = surface_.corners(t);
      const Vector before = unit(normalOf(originalCorners(t)));
      const Vector after = unit(normalOf({ asVector(c[0]), asVector(c[1]), asVector(c[2]) }));
      if (norm(before) > 0 && dot(before, after) < LeastCosine)
      {
        fail(static_cast<std::uint32_t>(t));
      }
    }
    const TrianglePairs pairs = findPairs(surface_, execution_);
    for (const TrianglePair& pair : pairs.pairs)
    {
      fail(pair.first);
      fail(pair.second);
    }
    return failing;
  }

  Surface& surface_;
  Displacement& d_;
  const double thickness_; // in levels
  Execution& execution_;
  std::vector<std::size_t> start_;    // of each vertex in around_, and the end
  std::vector<std::uint32_t> around_; // triangles
};

}

bool Displacement::hasLayers(std::int32_t boundary) const
{
  const auto& without = spec.boundariesWithout;
  return boundary != NoBoundary &&
    std::find(without.begin(), without.end(), boundary) == without.end();
}

Displacement displace(
  Surface& surface, const WallLayerSpec& spec, double thickness, Execution& execution)
{
  Displacement result;
  result.spec = spec;
  result.thickness = thickness;
  result.original = surface.vertices;
  Displacer(surface, result, thickness, execution).run();
  return result;
}

Displacement displaceAgain(Surface& surface, const Displacement& before,
  std::vector<std::uint32_t> notAt, int rings, Execution& execution)
{
  Displacement result = before;
  Displacer(surface, result, before.thickness, execution).runAgain(std::move(notAt), rings);
  return result;
}

}
