// SPDX-License-Identifier: BSD-3-Clause
#include "Layers/AskedThickness.h"

#include <algorithm>
#include <cmath>

namespace cartesian
{

namespace
{

// Boxes that differ by less are as large as each other: rounding to levels and planes moved aside count for nothing.
constexpr double SameSize = 0.01;

// The shortest side of an undivided box, in levels.
double shortestSide(const Meshlines& planes)
{
  double least = LevelsOfTheDomain;
  for (const auto& axis : planes)
  {
    for (std::size_t i = 0; i + 1 < axis.size(); ++i)
    {
      least = std::min(least, double(axis[i + 1]) - axis[i]);
    }
  }
  return least;
}

// `undivided`: the shortest side of all boxes, were none divided.
double shortestSide(const Box& box, double undivided)
{
  double least = LevelsOfTheDomain;
  for (std::size_t axis = 0; axis < 3; ++axis)
  {
    least = std::min(least, double(box.high[axis]) - box.low[axis]);
  }
  const double halved = std::ldexp(undivided, std::ilogb(least / undivided * std::sqrt(2.0)));
  return std::abs(least / halved - 1) < SameSize ? halved : least;
}

}

std::vector<double> usualThicknesses(
  const OutputMesh& mesh, const std::vector<BoundaryFace>& faces, const WallLayerSpec& spec)
{
  const Boxes& boxes = mesh.boxes();
  const double undivided = shortestSide(boxes.planes);
  std::vector<double> thicknesses;
  for (const BoundaryFace& face : faces)
  {
    const double side = shortestSide(boxes.box(mesh.boxOf(face.cell)), undivided);
    thicknesses.push_back(totalThickness(spec, side * boxes.lattice.step()));
  }
  return thicknesses;
}

}
