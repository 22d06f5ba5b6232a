// SPDX-License-Identifier: BSD-3-Clause
#include "Polyhedra/OffsetPlanes.h"

#include <algorithm>
#include <array>

namespace cartesian
{

namespace
{

constexpr double SinOfOnePlane = 0.05; // normals that differ by less are of one facet
constexpr double Damping = 1e-3;       // of the directions that facets hardly determine
constexpr int DampedSteps = 8;         // until what they do determine is exact to rounding

using Matrix = std::array<Vector, 3>;

Vector solve(const Matrix& m, const Vector& right)
{
  const double determinant = dot(m[0], cross(m[1], m[2]));
  const Vector sum =
    plus(plus(scaled(cross(m[1], m[2]), right[0]), scaled(cross(m[2], m[0]), right[1])),
      scaled(cross(m[0], m[1]), right[2]));
  return scaled(sum, 1 / determinant);
}

}

void addFacet(std::vector<Facet>& facets, const Facet& added)
{
  for (Facet& facet : facets)
  {
    if (dot(facet.normal, added.normal) > 0 &&
      norm(cross(facet.normal, added.normal)) < SinOfOnePlane)
    {
      facet.normal =
        unit(plus(scaled(facet.normal, facet.angle), scaled(added.normal, added.angle)));
      const double angle = facet.angle + added.angle;
      facet.distance += (added.distance - facet.distance) * (added.angle / angle);
      facet.angle = angle;
      return;
    }
  }
  facets.push_back(added);
}

std::vector<Vector> independentNormals(const std::vector<Facet>& facets, double sine)
{
  std::vector<Vector> normals;
  for (const Facet& facet : facets)
  {
    const Vector rest = within(normals, facet.normal);
    if (norm(rest) > sine && normals.size() < 3)
    {
      normals.push_back(unit(rest));
    }
  }
  return normals;
}

Vector within(const std::vector<Vector>& normals, Vector v)
{
  for (const Vector& normal : normals)
  {
    v = minus(v, scaled(normal, dot(v, normal)));
  }
  return v;
}

Vector meetingPoint(const std::vector<Facet>& facets, const std::vector<Vector>& fixed)
{
  Matrix squares{};
  Vector sum{};
  double angles = 0;
  double longest = 0;
  for (const Facet& facet : facets)
  {
    const Vector normal = within(fixed, facet.normal);
    for (std::size_t i = 0; i < 3; ++i)
    {
      squares[i] = plus(squares[i], scaled(normal, facet.angle * normal[i]));
    }
    sum = plus(sum, scaled(normal, facet.angle * facet.distance));
    angles += facet.angle;
    longest = std::max(longest, facet.distance);
  }
  for (std::size_t i = 0; i < 3; ++i)
  {
    squares[i][i] += Damping * angles;
  }
  Vector at = scaled(unit(sum), longest);
  for (int step = 0; step < DampedSteps && angles > 0; ++step)
  {
    at = solve(squares, plus(sum, scaled(at, Damping * angles)));
  }
  longest *= LongestMitre;
  return norm(at) > longest ? scaled(unit(at), longest) : at;
}

}
