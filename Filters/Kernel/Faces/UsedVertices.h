// SPDX-License-Identifier: BSD-3-Clause
// The vertices of the global mesh that cells use, stored as runs along x: memory grows with the mesh, not
// with the grid.
#pragma once

#include "Faces/InnerFaces.h"

namespace cartesian
{

// How cells use a node.
enum class NodeRole : std::uint8_t
{
  Unused,
  Plain,  // it is not a vertex of the global mesh, or not known to be
  Vertex, // it is a vertex of the global mesh
};

class UsedVertices
{
  struct VertexRun
  {
    std::uint32_t begin; // i
    std::uint32_t end;
    std::uint32_t rank; // of vertex begin
  };

public:
  // Takes the vertices of undivided boxes of these layers that become hexahedra, and of used grid nodes.
  UsedVertices(const Boxes& boxes, const Sides& sides, const Nodes& nodes,
    const std::vector<NodeRole>& used, SlabRange layers, Execution& execution);

  // The number of used vertices in the row j + k * (planes along y).
  std::size_t count(std::size_t row) const
  {
    if (rowStart_[row] == rowStart_[row + 1])
    {
      return 0;
    }
    const VertexRun& last = runs_[rowStart_[row + 1] - 1];
    return last.rank + (last.end - last.begin);
  }

  // The zero-based rank of a used vertex within its row. Its neighbour i + 1 in the same box is the next.
  std::size_t rank(std::uint32_t i, std::uint32_t j, std::uint32_t k) const;

  // Calls visit(rank, i) for the used vertices of a row, in order.
  template <class Visitor>
  void forEach(std::size_t row, Visitor&& visit) const
  {
    for (std::size_t r = rowStart_[row]; r < rowStart_[row + 1]; ++r)
    {
      for (std::uint32_t i = runs_[r].begin; i < runs_[r].end; ++i)
      {
        visit(runs_[r].rank + (i - runs_[r].begin), i);
      }
    }
  }

  // Whether a grid node of the row of points (j, k) is a vertex of the global mesh; then `i`.
  static bool isVertex(
    const Meshlines& planes, const Point& node, std::size_t j, std::size_t k, std::uint32_t& i);

  // Ranks within one row, for vertices that come in order.
  class Walk
  {
  public:
    Walk(const UsedVertices& rows, std::size_t row)
      : run_(rows.runs_.data() + rows.rowStart_[row])
    {
    }

    std::size_t rank(std::uint32_t i)
    {
      for (; run_->end <= i; ++run_)
      {
      }
      return run_->rank + (i - run_->begin);
    }

  private:
    const VertexRun* run_;
  };

private:
  std::vector<VertexRun> runs_;
  std::vector<std::size_t> rowStart_;
  std::size_t rowLength_;
};

}
