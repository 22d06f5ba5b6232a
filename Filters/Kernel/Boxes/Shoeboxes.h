// SPDX-License-Identifier: BSD-3-Clause
// Shoeboxes (section 4.3): which triangles pass through which global boxes, exactly.
//
// The shoeboxes are the global boxes. A triangle passes through a box if a piece of it lies between
// the box's planes. This is decided on the exact pieces, so that even a large slanted triangle is
// listed only for the boxes it meets.
#pragma once

#include "Base/Sorting.h"
#include "Lattice/TriangleSlicing.h"
#include "Surface/Surface.h"

namespace cartesian
{

// Of a shoebox.
using TriangleRange = std::pair<const std::uint32_t*, const std::uint32_t*>;

// Rows run along x and are numbered j + k * (boxes along y).
struct Shoeboxes
{
  // Boxes that a triangle passes through, in order of rows, then of i.
  std::vector<std::size_t> rowStart;      // first box of each row, and the end
  std::vector<std::uint32_t> column;      // i of each box
  std::vector<std::size_t> triangleStart; // of each box, and the end
  std::vector<std::uint32_t> triangle;    // ascending within a box

  // The triangles of box i of a row, ascending.
  TriangleRange triangles(std::size_t row, std::uint32_t i) const
  {
    const auto begin = column.begin() + static_cast<std::ptrdiff_t>(rowStart[row]);
    const auto end = column.begin() + static_cast<std::ptrdiff_t>(rowStart[row + 1]);
    const auto found = std::lower_bound(begin, end, i);
    if (found == end || *found != i)
    {
      return { nullptr, nullptr };
    }
    const auto box = static_cast<std::size_t>(found - column.begin());
    return { triangle.data() + triangleStart[box], triangle.data() + triangleStart[box + 1] };
  }
};

Shoeboxes fillShoeboxes(const Surface& surface, const Meshlines& planes, Execution& execution);

}
