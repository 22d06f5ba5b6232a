// SPDX-License-Identifier: BSD-3-Clause
// Those vertices of the global mesh that cells use: runs along x, so that memory grows with the mesh
// and not with the grid.
#pragma once

#include "Faces/InnerFaces.h"

namespace cartesian
{

// How cells use a node of faces.
enum class Use : std::uint8_t
{
  Nowhere,
  Between,  // it is no vertex of the global mesh, or that is not known yet
  AsVertex, // it is one
};

class VertexRows
{
  struct Run
  {
    std::uint32_t begin; // i
    std::uint32_t end;
    std::uint32_t place; // of vertex begin, in its row
  };

public:
  // Vertices of undivided boxes of these layers that become hexahedra, and grid nodes
  // that are used.
  VertexRows(const Boxes& boxes, const Sides& sides, const Nodes& nodes,
    const std::vector<Use>& used, Layers layers, Execution& execution);

  // How many there are in the row j + k * (planes along y).
  std::size_t count(std::size_t row) const
  {
    if (rowStart_[row] == rowStart_[row + 1])
    {
      return 0;
    }
    const Run& last = runs_[rowStart_[row + 1] - 1];
    return last.place + (last.end - last.begin);
  }

  // The how many-th of its row a used vertex is, from 0. Its neighbour i + 1 in the same box is the
  // next.
  std::size_t place(std::uint32_t i, std::uint32_t j, std::uint32_t k) const;

  // Calls visit(place, i) for the vertices of a row, in order.
  template <class Visitor>
  void forEach(std::size_t row, Visitor&& visit) const
  {
    for (std::size_t r = rowStart_[row]; r < rowStart_[row + 1]; ++r)
    {
      for (std::uint32_t i = runs_[r].begin; i < runs_[r].end; ++i)
      {
        visit(runs_[r].place + (i - runs_[r].begin), i);
      }
    }
  }

  // Whether a grid node of the row of points (j, k) is a vertex of the global mesh; then `i`.
  static bool isVertex(
    const Meshlines& planes, const Point& node, std::size_t j, std::size_t k, std::uint32_t& i);

  // Places in one row of vertices that come in order.
  class Walk
  {
  public:
    Walk(const VertexRows& rows, std::size_t row)
      : run_(rows.runs_.data() + rows.rowStart_[row])
    {
    }

    std::size_t place(std::uint32_t i)
    {
      for (; run_->end <= i; ++run_)
      {
      }
      return run_->place + (i - run_->begin);
    }

  private:
    const Run* run_;
  };

private:
  std::vector<Run> runs_;
  std::vector<std::size_t> rowStart_;
  std::size_t rowLength_;
};

}
