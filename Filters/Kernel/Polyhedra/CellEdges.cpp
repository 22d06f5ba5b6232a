// SPDX-License-Identifier: BSD-3-Clause
#include "Polyhedra/CellEdges.h"

#include "Polyhedra/CellGeometry.h"

#include <algorithm>
#include <limits>
#include <tuple>

namespace cartesian
{

namespace
{

// Faces whose normals differ by more than this, in degrees, are back to back. They are taken for the
// edge of a thin cell, not of a thin gap in a cell: only rounding tells the two apart.
constexpr double KnifeFrom = 180 - 1e-3;

}

void CellEdges::sort()
{
  std::sort(edges_.begin(), edges_.end(), [](const Edge& left, const Edge& right) {
    return std::tie(left.low, left.high, left.ahead, left.normal) <
      std::tie(right.low, right.high, right.ahead, right.normal);
  });
}

CellEdges::Result CellEdges::measureGroup(
  std::size_t begin, std::size_t end, const Vector& along) const
{
  // Edges that run back are sorted before those that run ahead.
  const auto middle = static_cast<std::size_t>(
    std::find_if(edges_.begin() + static_cast<std::ptrdiff_t>(begin),
      edges_.begin() + static_cast<std::ptrdiff_t>(end), [](const Edge& e) { return e.ahead; }) -
    edges_.begin());
  Result result;
  result.open = 2 * middle == begin + end ? 0 : 1;
  for (std::size_t ahead = middle; middle > begin && ahead < end; ++ahead)
  {
    double least = std::numeric_limits<double>::infinity();
    for (std::size_t back = begin; back < middle; ++back)
    {
      const Vector& u = normals_[edges_[ahead].normal];
      const Vector& v = normals_[edges_[back].normal];
      // Rotation about the edge from one normal to the other; convex if not concave.
      const double bend = angle(u, v);
      const bool concave = dot(cross(u, v), along) < 0 && bend < KnifeFrom;
      least = std::min(least, concave ? bend : -bend);
    }
    result.concavity = std::max(result.concavity, least);
  }
  return result;
}

}
