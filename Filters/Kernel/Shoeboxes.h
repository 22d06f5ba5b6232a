// Shoeboxes (section 4.3): which triangles pass through which global boxes, exactly.
//
// The shoeboxes are the global boxes. A triangle passes through a box when something of it lies
// between the box's planes: decided on the exact pieces, so that a large slanted triangle is
// filed under the boxes it meets and no others.
#pragma once

#include "Rows.h"
#include "Sorting.h"
#include "Surface.h"

namespace cartesian
{

// Rows run along x and are numbered j + k * (boxes along y).
struct Shoeboxes
{
  // Boxes that a triangle passes through, in order of rows, then of i.
  std::vector<std::size_t> rowStart;      // first box of each row, and the end
  std::vector<std::uint32_t> column;      // i of each box
  std::vector<std::size_t> triangleStart; // of each box, and the end
  std::vector<std::uint32_t> triangle;    // ascending within a box

  // The triangles of box i of a row, ascending; none where no triangle passes.
  std::pair<const std::uint32_t*, const std::uint32_t*> triangles(
    std::size_t row, std::uint32_t i) const
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

// Crossings of the surface with the mesh lines along one axis: those lines where a plane of
// rows.outer meets one of rows.middle, numbered middle + outer * (planes of middle).
struct LineCrossing
{
  std::uint32_t line;
  std::uint32_t planesBelow; // planes of rows.along below the crossing

  bool operator<(const LineCrossing& other) const { return planesBelow < other.planesBelow; }
};

struct LineCrossings
{
  RowAxes axes;
  std::size_t linesOfMiddle = 0;
  Buckets<LineCrossing> crossings; // by line

  // How often the line crosses the surface, in all.
  std::size_t total(std::size_t middle, std::size_t outer) const
  {
    const std::size_t line = middle + outer * linesOfMiddle;
    return crossings.start[line + 1] - crossings.start[line];
  }

  // ... and below the plane of rows.along with this index.
  std::size_t below(std::size_t middle, std::size_t outer, std::uint32_t plane) const
  {
    const std::size_t line = middle + outer * linesOfMiddle;
    return std::upper_bound(
             crossings.begin(line), crossings.end(line), LineCrossing{ 0, plane }) -
      crossings.begin(line);
  }
};

struct SurfaceRows
{
  Shoeboxes shoeboxes;
  LineCrossings crossings; // with the lines along x
};

// Both at once: they come from the same pieces.
SurfaceRows shoeboxes(const Surface& surface, const Meshlines& planes, Execution& execution);

LineCrossings lineCrossings(
  const Surface& surface, const Meshlines& planes, int along, Execution& execution);

}
