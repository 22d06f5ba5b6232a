// SPDX-License-Identifier: BSD-3-Clause
// Fans of triangles around the centres of faces, the same from both of a face's cells: so OpenFOAM takes areas and volumes
// of faces that are not flat (Polyhedra/CellGeometry.h).
#pragma once

#include "Quality/FaceCorners.h"

#include <array>
#include <functional>

namespace cartesian
{

// How far a quadrilateral may be off its plane to stay whole, relative to its longer diagonal.
constexpr double FlatQuadrilateral = 1e-12;

// Whether it is flat and convex. The same for the same corners from whichever they begin, in either direction: `ids` tell
// them apart.
bool staysWhole(const std::array<Vector, 4>& corners, const std::array<std::uint32_t, 4>& ids);

// Whether a polygon of any size is as flat, relative to its longest diagonal from its first corner.
template <class Corner>
bool isFlat(std::size_t size, Corner&& corner)
{
  const Vector first = corner(0);
  Vector area{};
  double farthest = 0;
  for (std::size_t i = 1; i + 1 < size; ++i)
  {
    const Vector from = minus(corner(i), first);
    area = plus(area, cross(from, minus(corner(i + 1), first)));
    farthest = std::max(farthest, dot(from, from));
  }
  const double most = FlatQuadrilateral * std::sqrt(farthest) * norm(area);
  for (std::size_t i = 1; i < size; ++i)
  {
    if (!(std::abs(dot(minus(corner(i), first), area)) <= most))
    {
      return false;
    }
  }
  return true;
}

constexpr std::uint32_t NoPoint = ~std::uint32_t(0);

struct FaceFans
{
  std::vector<std::uint32_t> fanOf; // of each face of each cell, or NoPoint: it has none
  std::vector<std::uint32_t> faces; // a face for each fan
  std::vector<Vector> centres;      // of the fans

  std::size_t count() const { return faces.size(); }
};

// Fans of the faces for which `hasFan(corners, face)`, which must be the same for both faces of the same corners. Their order is
// that of their points.
FaceFans findFans(const CellFaces& cells, const double* points,
  const std::function<bool(const FaceCorners&, std::size_t)>& hasFan, Execution& execution);

}
