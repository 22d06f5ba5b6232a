// SPDX-License-Identifier: BSD-3-Clause
#include "OpenFoam/SymmetryPlanes.h"

#include "Lattice/Vector.h"

namespace cartesian
{

namespace
{

// The square by which a unit normal may differ from the mean: OpenFOAM dies of 1e-15 in a symmetryPlane, and rounds.
constexpr double LargestDifference = 1e-17;

// Twice the area, outwards.
Vector areaOf(const FoamMesh& mesh, std::size_t face)
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

bool isPlane(const FoamMesh& mesh, std::size_t first, std::size_t count)
{
  std::vector<Vector> normals;
  Vector sum{};
  for (std::size_t face = first; face < first + count; ++face)
  {
    const Vector area = areaOf(mesh, face);
    normals.push_back(norm(area) > 0 ? unit(area) : area);
    sum = plus(sum, normals.back());
  }
  const Vector mean = scaled(sum, 1 / static_cast<double>(count));
  return std::all_of(normals.begin(), normals.end(), [&](const Vector& normal) {
    const Vector difference = minus(normal, mean);
    return dot(difference, difference) <= LargestDifference;
  });
}

}

std::vector<FoamPatch> withSymmetries(const FoamMesh& mesh)
{
  std::vector<FoamPatch> patches = mesh.patches;
  std::size_t first = mesh.neighbour.size();
  for (FoamPatch& patch : patches)
  {
    const bool isNew = patch.type.empty() && patch.sample.region.empty() && patch.partner.empty() &&
      patch.processes.other < 0;
    if (isNew && isSymmetry(patch.name))
    {
      const bool isWhole = !mesh.addressing && patch.count > 0;
      patch.type = isWhole && isPlane(mesh, first, patch.count) ? "symmetryPlane" : "symmetry";
    }
    first += patch.count;
  }
  return patches;
}

}
