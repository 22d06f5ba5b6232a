// SPDX-License-Identifier: BSD-3-Clause
#include "Cells/FlatBorders.h"

#include "Polyhedra/CellGeometry.h"

namespace cartesian
{

namespace
{

// Normals in one plane make at most this angle, in degrees.
constexpr double OnePlane = 5;

}

bool hasBorderInPlane(const Nodes& nodes, const WallMesh& wall, std::size_t cell)
{
  const double least = std::cos(radians(OnePlane));
  std::vector<std::pair<std::int32_t, Vector>> normals; // by boundary
  bool any = false;
  wall.forEachUse(cell, [&](const FaceUse& use) {
    if (any || !wall.faces.isPatch(use.face))
    {
      return;
    }
    std::vector<Vector> corners;
    wall.faces.forEachNode(
      use, [&](std::uint32_t node) { corners.push_back(toVector(nodes.at[node])); });
    const Vector normal = unit(
      measureFace(corners.size(), [&](std::size_t i) -> const Vector& { return corners[i]; }).area);
    const std::int32_t boundary = wall.faces.boundary[use.face];
    for (const auto& [other, ofOther] : normals)
    {
      any = any || (other != boundary && dot(ofOther, normal) > least);
    }
    normals.emplace_back(boundary, normal);
  });
  return any;
}

}
