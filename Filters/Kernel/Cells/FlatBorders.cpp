// SPDX-License-Identifier: BSD-3-Clause
#include "Cells/FlatBorders.h"

#include "Polyhedra/CellGeometry.h"

#include <algorithm>

namespace cartesian
{

namespace
{

// Normals in one plane make at most this angle, in degrees.
constexpr double OnePlane = 5;

}

bool haveBorderInPlane(const std::vector<BoundaryAndNormal>& patches)
{
  const double least = std::cos(radians(OnePlane));
  bool any = false;
  for (auto one = patches.begin(); !any && one != patches.end(); ++one)
  {
    any = std::any_of(patches.begin(), one, [&](const BoundaryAndNormal& other) {
      return other.boundary != one->boundary && dot(other.normal, one->normal) > least;
    });
  }
  return any;
}

bool hasBorderInPlane(const Nodes& nodes, const WallMesh& wall, std::size_t cell)
{
  std::vector<BoundaryAndNormal> patches;
  wall.forEachUse(cell, [&](const FaceUse& use) {
    if (!wall.faces.isPatch(use.face))
    {
      return;
    }
    std::vector<Vector> corners;
    wall.faces.forEachNode(
      use, [&](std::uint32_t node) { corners.push_back(toVector(nodes.at[node])); });
    patches.push_back({ wall.faces.boundary[use.face],
      unit(measureFace(corners.size(), [&](std::size_t i) -> const Vector& {
        return corners[i];
      }).area) });
  });
  return haveBorderInPlane(patches);
}

}
