// The faces of a mesh's cells, or of polyhedra that are given by their corners.
#pragma once

#include "Quality/FaceList.h"
#include "Support/Pipeline.h"

#include <limits>
#include <map>

namespace cartesian
{

using Polygon = std::vector<Vector>;
using Polyhedron = std::vector<Polygon>; // outward faces

struct FacedCells
{
  std::vector<double> points;
  CellFaces cells;

  // By how much places may be off that are computed in double precision.
  double rounding() const
  {
    double most = 0;
    for (const double x : points)
    {
      most = std::max(most, std::abs(x));
    }
    return 16 * std::numeric_limits<double>::epsilon() * most;
  }

  void addCell() { cells.firstFace.push_back(cells.firstCorner.size()); }
  void addFace() { cells.firstCorner.push_back(cells.corners.size()); }
  void finish()
  {
    addCell();
    addFace();
  }
  Vector at(std::uint32_t point) const
  {
    return { points[3 * point], points[3 * point + 1], points[3 * point + 2] };
  }
};

// Points at the same place are one.
inline FacedCells facedCells(const std::vector<Polyhedron>& polyhedra)
{
  std::map<Vector, std::uint32_t> numbers;
  FacedCells result;
  for (const Polyhedron& cell : polyhedra)
  {
    result.addCell();
    for (const Polygon& face : cell)
    {
      result.addFace();
      for (const Vector& corner : face)
      {
        const auto [place, isNew] =
          numbers.try_emplace(corner, static_cast<std::uint32_t>(numbers.size()));
        result.cells.corners.push_back(place->second);
        if (isNew)
        {
          result.points.insert(result.points.end(), corner.begin(), corner.end());
        }
      }
    }
  }
  result.finish();
  return result;
}

inline FacedCells facedCells(const MeshArrays& mesh)
{
  constexpr std::array<std::array<std::size_t, 4>, 6> Sides{ { { 0, 4, 7, 3 }, { 1, 2, 6, 5 },
    { 0, 1, 5, 4 }, { 3, 7, 6, 2 }, { 0, 3, 2, 1 }, { 4, 5, 6, 7 } } };
  FacedCells result;
  result.points = mesh.points;
  for (std::size_t cell = 0; cell < mesh.cells(); ++cell)
  {
    result.addCell();
    if (mesh.types[cell] == MeshArrays::Hexahedron)
    {
      for (const auto& side : Sides)
      {
        result.addFace();
        for (const std::size_t corner : side)
        {
          result.cells.corners.push_back(static_cast<std::uint32_t>(
            mesh.connectivity[static_cast<std::size_t>(mesh.offsets[cell]) + corner]));
        }
      }
      continue;
    }
    auto at = static_cast<std::size_t>(mesh.faceStart[cell]);
    for (Id faces = mesh.faceStream[at++]; faces > 0; --faces)
    {
      result.addFace();
      for (Id corners = mesh.faceStream[at++]; corners > 0; --corners)
      {
        result.cells.corners.push_back(static_cast<std::uint32_t>(mesh.faceStream[at++]));
      }
    }
  }
  result.finish();
  return result;
}

}
