// SPDX-License-Identifier: BSD-3-Clause
// Which closed sheets pass through each other, rather than touch.
//
// Where a triangle's share of another runs through the middle of that one, the sides on which it lies are sides on
// which its sheet lies. A sheet on both sides of another passes through it, and so do two that each have a part inside
// the other. Within the snap distance (Snapping.h) of a plane a corner lies on it: so what stands on a floor touches it,
// however the file rounds its feet.
#pragma once

#include "Repair/ManifoldComponents.h"
#include "Repair/TrianglePairs.h"

#include <map>

namespace cartesian
{

class ComponentIntersections
{
public:
  // `pairs`: of triangles that cross. `volume`: of each sheet, with all triangles facing as its first.
  ComponentIntersections(const Surface& surface, const ManifoldComponents& sheets,
    const std::vector<TrianglePair>& pairs, const std::vector<double>& volume);

  bool cross(std::uint32_t a, std::uint32_t b) const;

  // Also where they only touch, in triangles that cross.
  bool meet(std::uint32_t a, std::uint32_t b) const;

private:
  enum Sides : std::uint8_t
  {
    Outside = 1,
    Inside = 2,
    Both = 3,
  };

  std::uint8_t sidesOf(std::uint32_t a, std::uint32_t b) const;

  std::map<std::array<std::uint32_t, 2>, std::uint8_t>
    sides_; // of the second sheet, where the first has parts
};

}
