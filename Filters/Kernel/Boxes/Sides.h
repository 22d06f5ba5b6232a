// SPDX-License-Identifier: BSD-3-Clause
// Common Rectangular Sides of Boxes (section 6, step 9): U, V and W sides, perpendicular to x, y, z.
#pragma once

#include "Base/Execution.h"
#include "Boxes/Boxes.h"

namespace cartesian
{

// The rectangle that two neighbouring boxes share; its normal points from low to high.
struct Side
{
  std::uint32_t low;                   // box below the plane, or None
  std::uint32_t high;                  // box above, or None
  std::array<std::uint32_t, 3> corner; // the rectangle's lowest corner, fine
  std::array<std::uint8_t, 2> size;    // fine, along the two other axes in cyclic order
  std::uint8_t axis;
};

// A side of a box, and which of its two boxes it is.
struct SideOfBox
{
  std::uint32_t side : 31;
  std::uint32_t upper : 1; // the box is the side's lower one: the side is on top of it

  SideOfBox() = default;
  SideOfBox(std::uint32_t s, bool up)
    : side(s & 0x7fffffffu)
    , upper(up ? 1 : 0)
  {
  }
};

// Boxes with a part of the surface in them or with hanging nodes on them become polyhedra. Their
// sides are listed, in order of the box that owns them: the lower box if it becomes a polyhedron,
// else the upper. All other boxes become hexahedra, and sides between those are plain.
struct Sides
{
  static constexpr std::uint32_t HexahedronBit = 1u << 31;

  std::vector<std::uint32_t> polyhedral; // boxes, in order
  std::vector<std::uint32_t> divided;    // other boxes that are smaller than their global box
  RawVector<std::uint32_t>
    ordinal; // of each box: in `polyhedral`, in `divided` with HexahedronBit, or None
  std::vector<std::uint32_t> patchBox; // of polyhedral boxes: number among the intersected, or None
  RawVector<Side> common;              // of two neighbouring boxes each
  std::vector<std::size_t> ownStart;   // first side that each polyhedral box owns, and the end
  std::vector<std::size_t> boxStart;   // first of each polyhedral box's sides in ofBox, and the end
  RawVector<SideOfBox> ofBox;

  // The number among the polyhedral boxes, or None.
  std::uint32_t polyhedralOrdinal(std::uint32_t box) const
  {
    return box == None || (ordinal[box] & HexahedronBit) != 0 ? None : ordinal[box];
  }
};

Sides findSides(const Boxes& boxes, Execution& execution);

// Nodes of the fine grid that hang on the line along `axis` from `from`, `length` fine steps long:
// ends of boxes around it, in order, without the line's own ends. `near`: a global box at the line.
void hangingNodes(const Boxes& boxes, int axis, const FinePoint& from, std::int64_t length,
  std::uint32_t near, std::vector<std::int64_t>& positions);

// The corners (bits as in Box::corners) of a box's lower (0) or upper (1) side, counter-clockwise
// seen from above.
std::array<unsigned, 4> sideCorners(int axis, unsigned upper);

}
