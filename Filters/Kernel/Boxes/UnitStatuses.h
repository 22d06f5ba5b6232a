// SPDX-License-Identifier: BSD-3-Clause
// In/out statuses within a global box or a part of it (section 4.5): of its units and of their vertices.
#pragma once

#include "Boxes/Boxes.h"
#include "Boxes/Shoeboxes.h"
#include "Boxes/UnitPlanes.h"

namespace cartesian
{

class UnitStatuses
{
public:
  // Of a cube in the global box `index`, with 2^bits units along each axis. `triangles`: those that pass through the
  // cube; `low`: the winding around its low corner. Keeps its storage.
  void compute(const Surface& surface, const TriangleRange& triangles, const Meshlines& planes,
    const std::array<std::uint32_t, 3>& index, const Cube& cube, int bits, const Winding& low);

  // Statuses of the units, x fastest.
  const std::vector<BoxStatus>& units() const { return units_; }

  // To be called once before trianglesIn().
  void sortPassing();

  // The triangles that pass through a unit, ascending.
  std::vector<std::uint32_t> trianglesIn(std::size_t unit) const;

  // The winding around the low corner of a unit.
  const Winding& lowOf(std::size_t unit) const;

  // The bits of the corners of a box that consists of units, as in Box::corners.
  std::uint8_t corners(const LocalBox& box) const;

private:
  std::size_t vertex(std::size_t x, std::size_t y, std::size_t z) const;
  void findVertices(const Surface& surface, const TriangleRange& triangles, const Winding& low);
  void findUnits(const Surface& surface, const TriangleRange& triangles);

  Cube cube_;
  int bits_ = 0;
  UnitPlanes planes_;
  std::vector<Winding> vertices_;
  std::vector<BoxStatus> units_;
  std::vector<std::pair<std::uint32_t, std::uint32_t>> passing_; // unit, triangle
};

// The winding around one point `at` of a global box or a part of it, given the winding `low` around its low corner;
// `triangles`: those that pass through it.
// All levels of both points are even.
Winding windingAt(const Surface& surface, const TriangleRange& triangles, const Point& corner,
  const Winding& low, const Point& at);

}
