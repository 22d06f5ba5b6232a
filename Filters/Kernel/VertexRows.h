// Numbers of those vertices of the global mesh that cells use: runs along x, so that memory grows
// with the mesh and not with the grid.
#pragma once

#include "InnerFaces.h"

namespace cartesian
{

class VertexRows
{
public:
  // Vertices of undivided boxes that become hexahedra, and grid nodes with used[node] != 0.
  VertexRows(const Boxes& boxes, const Sides& sides, const Nodes& nodes,
    const std::vector<std::uint8_t>& used, Execution& execution);

  std::size_t size() const { return size_; }

  // The number of a used vertex. Its neighbour i + 1 in the same box has the next number.
  std::size_t number(std::uint32_t i, std::uint32_t j, std::uint32_t k) const;

  // Calls visit(number, i) for the vertices of row j + k * (planes along y), in order.
  template <class Visitor>
  void forEach(std::size_t row, Visitor&& visit) const
  {
    for (std::size_t r = rowStart_[row]; r < rowStart_[row + 1]; ++r)
    {
      for (std::uint32_t i = runs_[r].begin; i < runs_[r].end; ++i)
      {
        visit(runs_[r].number + (i - runs_[r].begin), i);
      }
    }
  }

  // Whether a grid node of the row of points (j, k) is a vertex of the global mesh; then `i`.
  static bool isVertex(
    const Meshlines& planes, const Point& node, std::size_t j, std::size_t k, std::uint32_t& i);

private:
  struct Run
  {
    std::uint32_t begin; // i
    std::uint32_t end;
    std::size_t number; // of vertex begin
  };

  std::vector<Run> runs_;
  std::vector<std::size_t> rowStart_;
  std::size_t rowLength_;
  std::size_t size_ = 0;
};

}
