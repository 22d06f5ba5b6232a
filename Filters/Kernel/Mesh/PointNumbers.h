// SPDX-License-Identifier: BSD-3-Clause
// Numbers of the points that cells use (section 6, step 11).
//
// Points are numbered row by row (Numbering.h), in each row: vertices of the global mesh, other grid
// nodes, points of patches, nodes that shaping added. So the numbers of a part's points (Decomposition.h)
// follow those of the part before it.
#pragma once

#include "Cells/Boundary.h"
#include "Faces/VertexRows.h"

namespace cartesian
{

class PointNumbers
{
public:
  // Of points that cells in these layers of boxes use.
  PointNumbers(const MeshParts& parts, Layers layers, Execution& execution);

  std::size_t size() const { return rowStart_.back(); }

  // The first number in the rows of a layer of points; size() beyond the last.
  std::size_t firstOfLayer(std::size_t k) const;

  // The number of a node, or None: not used.
  std::uint32_t ofNode(std::size_t node) const { return ofNode_[node]; }

  // The number of a used vertex of the global mesh. Its neighbour i + 1 in the same box has the next.
  std::uint32_t ofVertex(std::uint32_t i, std::uint32_t j, std::uint32_t k) const
  {
    return static_cast<std::uint32_t>(rowStart_[j + k * rowLength_] + vertices_.place(i, j, k));
  }

  // The same in the row j + k * (planes along y), for vertices that come in order.
  class Walk
  {
  public:
    Walk(const PointNumbers& numbers, std::size_t row)
      : first_(numbers.rowStart_[row])
      , places_(numbers.vertices_, row)
    {
    }

    std::uint32_t ofVertex(std::uint32_t i)
    {
      return static_cast<std::uint32_t>(first_ + places_.place(i));
    }

  private:
    std::size_t first_;
    VertexRows::Walk places_;
  };

  // Calls visit(number, i) for the used vertices of the row j + k * (planes along y), in order.
  template <class Visitor>
  void forEachVertex(std::size_t row, Visitor&& visit) const
  {
    vertices_.forEach(
      row, [&](std::size_t place, std::uint32_t i) { visit(rowStart_[row] + place, i); });
  }

private:
  PointNumbers(
    const MeshParts& parts, Layers layers, std::vector<Use>&& used, Execution& execution);

  static std::vector<Use> usedNodes(const MeshParts& parts, Layers layers, Execution& execution);

  std::size_t rowLength_;
  VertexRows vertices_;
  std::vector<std::size_t> rowStart_; // first number of each row, and the end
  std::vector<std::uint32_t> ofNode_;
};

}
