// Common Rectangular Sides of Boxes (section 6, step 9): U, V and W sides, perpendicular to x, y, z.
#pragma once

#include "Boxes.h"

namespace cartesian
{

constexpr std::uint32_t None = ~std::uint32_t(0);

// The rectangle that two neighbouring boxes share; its normal points from low to high.
struct Side
{
  std::uint32_t low;  // box below the plane, or None
  std::uint32_t high; // box above, or None
  std::uint8_t axis;
};

// The sides of intersected boxes, in order of the box that owns them: the lower box if it is
// intersected, else the upper. Sides of two inside boxes are plain rectangles and not listed.
struct Sides
{
  std::vector<std::uint32_t> intersected; // the intersected boxes, in order
  std::vector<std::uint32_t> ordinal;     // of each box among the intersected, or None
  std::vector<Side> sides;
  std::vector<std::size_t> ownStart; // first side that the n-th intersected box owns, and the end

  // Sides of the n-th intersected box: low x, high x, low y, high y, low z, high z.
  std::vector<std::array<std::uint32_t, 6>> ofBox;
};

Sides findSides(const Boxes& boxes, Execution& execution);

// The corners (bits as in Box::corners) of a box's lower (0) or upper (1) side, counter-clockwise
// seen from above.
std::array<unsigned, 4> sideCorners(int axis, unsigned upper);

// The box at (i, j, k) of the global mesh, or None where none is kept.
std::uint32_t boxAt(const Boxes& boxes, std::int64_t i, std::int64_t j, std::int64_t k);

}
