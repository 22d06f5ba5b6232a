// SPDX-License-Identifier: BSD-3-Clause
// Crossings on the edges of boxes that cancel each other, where all boxes are patched by Marching Cubes.
//
// Marching Cubes cannot handle edges that are crossed more than once. On each line between two corners of boxes,
// neighbouring crossings in opposite directions cancel each other. Polylines then continue from one to the other, in
// all boxes around the line.
#pragma once

#include "Patches/BoxSurface.h"

namespace cartesian
{

// Finds those of one box after the other.
class CrossingPairs
{
public:
  CrossingPairs(const Features& features, const Boxes& boxes)
    : features_(features)
    , boxes_(boxes)
  {
  }

  // `cancels`: else there are none.
  void find(const Box& box, const BoxSurface& piece, bool cancels);

  // The crossing that cancels this one, or None.
  std::uint32_t partnerOf(std::uint32_t point) const { return partner_[point]; }

private:
  void pairAlong(const Box& box, const BoxSurface& piece, std::size_t axis);
  void pairOnLine(const Box& box, const BoxSurface& piece, std::size_t axis,
    const std::uint32_t* begin, const std::uint32_t* end);
  void listHangingNodes(const Box& box, const Point& on, std::size_t axis);

  const Features& features_;
  const Boxes& boxes_;
  std::vector<std::uint32_t> partner_;   // of each point
  std::vector<std::uint32_t> crossings_; // points on two planes or more
  std::vector<std::uint32_t> onLines_;   // crossings on lines along one axis, line by line
  std::vector<std::int64_t> hanging_;
  std::vector<std::uint32_t> open_;
};

}
