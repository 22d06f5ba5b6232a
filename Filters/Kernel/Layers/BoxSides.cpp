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

// Of the area of walls with layers: if less of it is in smaller boxes, these do not count.
constexpr double LeastShare = 0.01;

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

double boxSideForLayers(
  const Boxes& boxes, const Patches& patches, const WallLayerSpec& layers, Execution& execution)
{
  const BoxSides of(boxes);
  const std::vector<std::uint32_t> box = intersectedBoxes(boxes, execution);
  std::map<double, std::size_t> count; // by their sides, ascending
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
  std::pair<double, double> most{ of.undivided(), 0 }; // side, area
  double all = 0;
  double before = 0; // of boxes smaller than those of the most
  for (const auto& [side, boxesOfIt] : count)
  {
    const double area = static_cast<double>(boxesOfIt) * side * side;
    if (area >= most.second)
    {
      most = { side, area };
      before = all;
    }
    all += area;
  }
  return (before > LeastShare * all ? 0.5 : 1) * most.first * boxes.lattice.step();
}

std::vector<double> boxSides(const OutputMesh& mesh, const std::vector<BoundaryFace>& faces)
{
  const Boxes& boxes = mesh.boxes();
  const BoxSides of(boxes);
  std::vector<double> sides;
  sides.reserve(faces.size());
  for (const BoundaryFace& face : faces)
  {
    sides.push_back(of.shortestSide(boxes.box(mesh.boxOf(face.cell))) * boxes.lattice.step());
  }
  return sides;
}

}
