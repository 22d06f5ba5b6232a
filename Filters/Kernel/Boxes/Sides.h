// SPDX-License-Identifier: BSD-3-Clause
// Common Rectangular Sides of Boxes (section 6, step 9): U, V and W sides, perpendicular to x, y, z.
#pragma once

#include "Base/Execution.h"
#include "Boxes/Boxes.h"

namespace cartesian
{

// The rectangle that two neighbouring boxes share. Its normal points from the low to the high one.
struct Side
{
  std::uint32_t low;                   // box below the plane, or None
  std::uint32_t high;                  // box above, or None
  std::array<std::uint32_t, 3> corner; // the rectangle's lowest corner, fine
  std::array<std::uint8_t, 2> level;   // of its size along the two other axes in cyclic order
  std::uint8_t axis;

  // Fine, along the first or second of these.
  std::int64_t size(std::size_t along) const { return FinePerBox >> level[along]; }
};

// A side of a box, and which of the side's two boxes that is.
struct SideOfBox
{
  std::uint32_t side : 31;
  std::uint32_t upper : 1; // it is an upper side of the box: the box is the side's low one

  SideOfBox() = default;
  SideOfBox(std::uint32_t s, bool up)
    : side(s & 0x7fffffffu)
    , upper(up ? 1 : 0)
  {
  }

  bool operator<(const SideOfBox& other) const { return side < other.side; }
};

// Boxes that the surface intersects or that have hanging nodes become polyhedra. Their sides are
// listed in order of the box that owns them: the low box if it becomes a polyhedron, else the high
// one. All other boxes become hexahedra, and sides between these are not listed.
struct Sides
{
  static constexpr std::uint32_t HexahedronBit = 1u << 31;

  std::vector<std::uint32_t> polyhedral; // boxes, in order
  std::vector<std::uint32_t> divided;    // hexahedra that are smaller than their global box
  RawVector<std::uint32_t>
    ordinal; // of each box: its index in `polyhedral`, in `divided` with HexahedronBit set, or None
  std::vector<std::uint32_t>
    patchBox;             // of each polyhedral box: its number among the intersected, or None
  RawVector<Side> common; // of two neighbouring boxes each
  std::vector<std::size_t> ownStart; // first side that each polyhedral box owns, and the end
  std::vector<std::size_t> boxStart; // first of each polyhedral box's sides in ofBox, and the end
  RawVector<SideOfBox> ofBox;

  // Once cells are assembled: only which boxes are polyhedral is still asked.
  void forgetSides()
  {
    RawVector<Side>().swap(common);
    RawVector<SideOfBox>().swap(ofBox);
    std::vector<std::size_t>().swap(ownStart);
    std::vector<std::size_t>().swap(boxStart);
  }

  // A box's number among the polyhedral ones, or None.
  std::uint32_t polyhedralOrdinal(std::uint32_t box) const
  {
    return box == None || (ordinal[box] & HexahedronBit) != 0 ? None : ordinal[box];
  }
};

Sides findSides(const Boxes& boxes, Execution& execution);

// Finds the hanging nodes of the fine grid on the line along `axis` from `from`, `length` fine
// steps long: ends of boxes around it, in order, without the line's own ends. `near`: a global box
// at the line.
void hangingNodes(const Boxes& boxes, int axis, const FinePoint& from, std::int64_t length,
  std::uint32_t near, std::vector<std::int64_t>& positions);

// The corners (bits as in Box::corners) of a box's lower (0) or upper (1) side, counter-clockwise
// as seen from above.
std::array<unsigned, 4> sideCorners(int axis, unsigned upper);

}
