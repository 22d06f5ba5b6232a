// SPDX-License-Identifier: BSD-3-Clause
#include "Layers/BoxSides.h"

#include <algorithm>
#include <cmath>
#include <map>

namespace cartesian
{

namespace
{

// Boxes that differ by less are as large as each other: rounding to levels and planes moved aside count for nothing.
constexpr double SameSize = 0.01;

// The shortest side of an undivided box, in levels.
double shortestOf(const Meshlines& planes)
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

}

BoxSides::BoxSides(const Boxes& boxes)
  : undivided_(shortestOf(boxes.planes))
{
}

double BoxSides::shortestSide(const Box& box) const
{
  double least = LevelsOfTheDomain;
  for (std::size_t axis = 0; axis < 3; ++axis)
  {
    least = std::min(least, double(box.high[axis]) - box.low[axis]);
  }
  const double halved = std::ldexp(undivided_, std::ilogb(least / undivided_ * std::sqrt(2.0)));
  return std::abs(least / halved - 1) < SameSize ? halved : least;
}

double usualBoxSide(
  const Boxes& boxes, const Patches& patches, const WallLayerSpec& layers, Execution& execution)
{
  const BoxSides of(boxes);
  const std::vector<std::uint32_t> box = intersectedBoxes(boxes, execution);
  std::map<double, std::size_t> count;
  for (std::size_t b = 0; b < box.size(); ++b)
  {
    const auto begin = patches.boundary.begin() + static_cast<std::ptrdiff_t>(patches.boxStart[b]);
    const auto end =
      patches.boundary.begin() + static_cast<std::ptrdiff_t>(patches.boxStart[b + 1]);
    if (std::any_of(begin, end,
          [&](std::int32_t wall) { return layers.hasLayers(patches.walls.boundary(wall)); }))
    {
      ++count[of.shortestSide(boxes.box(box[b]))];
    }
  }
  std::pair<double, std::size_t> most{ of.undivided(), 0 };
  for (const auto& [side, boxesOfIt] : count)
  {
    if (boxesOfIt >= most.second)
    {
      most = { side, boxesOfIt };
    }
  }
  return most.first * boxes.lattice.step();
}

std::vector<double> boxSides(const OutputMesh& mesh, const std::vector<BoundaryFace>& faces)
{
  const Boxes& boxes = mesh.boxes();
  const BoxSides of(boxes);
  std::vector<double> sides;
  for (const BoundaryFace& face : faces)
  {
    sides.push_back(of.shortestSide(boxes.box(mesh.boxOf(face.cell))) * boxes.lattice.step());
  }
  return sides;
}

}
