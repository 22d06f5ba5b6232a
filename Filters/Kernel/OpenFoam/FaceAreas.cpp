// SPDX-License-Identifier: BSD-3-Clause
#include "OpenFoam/FaceAreas.h"

namespace cartesian
{

Vector doubleAreaOf(const FoamMesh& mesh, std::size_t face)
{
  const auto at = [&](std::size_t corner) {
    const double* p = mesh.points.data() + 3 * std::size_t(mesh.corners[corner]);
    return Vector{ p[0], p[1], p[2] };
  };
  Vector area{};
  const Vector first = at(mesh.start[face]);
  for (std::size_t i = mesh.start[face] + 1; i + 1 < mesh.start[face + 1]; ++i)
  {
    area = plus(area, cross(minus(at(i), first), minus(at(i + 1), first)));
  }
  return area;
}

double areaOfFaces(const FoamMesh& mesh, std::size_t first, std::size_t count)
{
  double sum = 0;
  for (std::size_t face = first; face < first + count; ++face)
  {
    sum += norm(doubleAreaOf(mesh, face)) / 2;
  }
  return sum;
}

}
