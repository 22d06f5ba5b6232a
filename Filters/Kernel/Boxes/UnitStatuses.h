// SPDX-License-Identifier: BSD-3-Clause
// In/out statuses within one global box (section 4.5): of its units and of their vertices.
#pragma once

#include "Boxes/Boxes.h"
#include "Boxes/Shoeboxes.h"

namespace cartesian
{

class UnitStatuses
{
public:
  // `index`: of the global box; `low`: the winding around its low corner. Keeps its storage.
  void compute(const Surface& surface, const TriangleRange& triangles, const Meshlines& planes,
    const std::array<std::uint32_t, 3>& index, int depth, const Winding& low);

  // Statuses of the units, x fastest.
  const std::vector<BoxStatus>& units() const { return units_; }

  // The bits of the corners of a box that consists of units, as in Box::corners.
  std::uint8_t corners(
    const std::array<std::uint16_t, 3>& fineOffset, const std::array<std::uint8_t, 3>& level) const;

private:
  std::size_t vertex(std::size_t x, std::size_t y, std::size_t z) const;
  void findVertices(const Surface& surface, const TriangleRange& triangles, const Winding& low);
  void findUnits(const Surface& surface, const TriangleRange& triangles);

  int depth_ = 0;
  Meshlines planes_; // of the units, both ends included
  Meshlines inner_;  // without the ends
  std::vector<Winding> vertices_;
  std::vector<BoxStatus> units_;
};

// The winding around one point `at` of a global box, given the winding `low` around its low corner.
// All levels of both points are even.
Winding windingAt(const Surface& surface, const TriangleRange& triangles, const Point& corner,
  const Winding& low, const Point& at);

}
