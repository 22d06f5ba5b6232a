// SPDX-License-Identifier: BSD-3-Clause
// Searches every box of a grid through which the surface passes for octants.
#pragma once

#include "Base/Execution.h"
#include "Boxes/Octants.h"
#include "Boxes/Shoeboxes.h"

namespace cartesian
{

// Calls look(box, triangles, scratch, found), in which `box` is I, J, K in the grid of `planes`, the shoeboxes'
// own. The lists are in the order of the boxes, for any number of threads.
template <class Scratch, class Look>
std::vector<std::vector<Octants::Key>> findOctants(
  const Shoeboxes& shoeboxes, const Meshlines& planes, Execution& execution, const Look& look)
{
  constexpr std::size_t RowsAChunk = 16;
  const std::size_t rows = shoeboxes.rowStart.size() - 1;
  const std::size_t rowsAlongY = planes[1].size() - 1;
  std::vector<std::vector<Octants::Key>> found(chunks(rows, RowsAChunk));
  execution.forEach(rows, RowsAChunk, [&](std::size_t begin, std::size_t end) {
    Scratch scratch;
    for (std::size_t row = begin; row < end; ++row)
    {
      for (std::size_t b = shoeboxes.rowStart[row]; b < shoeboxes.rowStart[row + 1]; ++b)
      {
        const std::uint32_t* const all = shoeboxes.triangle.data();
        look(std::array<std::uint32_t, 3>{ shoeboxes.column[b],
               static_cast<std::uint32_t>(row % rowsAlongY),
               static_cast<std::uint32_t>(row / rowsAlongY) },
          TriangleRange{ all + shoeboxes.triangleStart[b], all + shoeboxes.triangleStart[b + 1] },
          scratch, found[begin / RowsAChunk]);
      }
    }
  });
  return found;
}

}
