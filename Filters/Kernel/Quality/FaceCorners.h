// SPDX-License-Identifier: BSD-3-Clause
// The faces and cells of a mesh in space.
#pragma once

#include "Polyhedra/CellGeometry.h"
#include "Quality/FaceList.h"

namespace cartesian
{

// The corners of faces and their places.
class FaceCorners
{
public:
  FaceCorners(const CellFaces& cells, const double* points)
    : cells_(cells)
    , points_(points)
  {
  }

  std::size_t size(std::size_t face) const
  {
    return cells_.firstCorner[face + 1] - cells_.firstCorner[face];
  }
  std::uint32_t id(std::size_t face, std::size_t i) const
  {
    return cells_.corners[cells_.firstCorner[face] + i];
  }
  Vector corner(std::size_t face, std::size_t i) const { return at(id(face, i)); }
  Vector at(std::uint32_t point) const
  {
    const double* p = points_ + 3 * std::size_t(point);
    return { p[0], p[1], p[2] };
  }

  FaceGeometry geometry(std::size_t face) const
  {
    return measureFace(size(face), [&](std::size_t i) { return corner(face, i); });
  }

  // Of a cell whose faces are turned outward (FaceList.h), and which become `faces`.
  CellGeometry geometryOfCell(std::size_t cell, std::vector<FaceGeometry>& faces) const
  {
    faces.clear();
    for (std::size_t face = cells_.firstFace[cell]; face < cells_.firstFace[cell + 1]; ++face)
    {
      faces.push_back(geometry(face));
    }
    return measureCell(
      faces.size(), [&](std::size_t i) -> const FaceGeometry& { return faces[i]; });
  }

private:
  const CellFaces& cells_;
  const double* points_;
};

}
