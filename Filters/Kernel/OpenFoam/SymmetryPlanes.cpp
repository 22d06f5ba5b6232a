// SPDX-License-Identifier: BSD-3-Clause
#include "OpenFoam/SymmetryPlanes.h"

#include "OpenFoam/FaceAreas.h"

namespace cartesian
{

namespace
{

// The square by which a unit normal may differ from the mean: OpenFOAM dies of 1e-15 in a symmetryPlane, and rounds.
constexpr double LargestDifference = 1e-17;

bool isPlane(const FoamMesh& mesh, std::size_t first, std::size_t count)
{
  std::vector<Vector> normals;
  Vector sum{};
  for (std::size_t face = first; face < first + count; ++face)
  {
    const Vector area = doubleAreaOf(mesh, face);
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
