// SPDX-License-Identifier: BSD-3-Clause
// What can be said of a cell edge by edge: whether it closes, and how concave it is.
#pragma once

#include "Lattice/Vector.h"

#include <cstdint>
#include <vector>

namespace cartesian
{

// The edges of one cell after the other; keeps its memory.
class CellEdges
{
public:
  struct Result
  {
    // Edges that are not run through as often one way as the other: the cell has a gap there.
    std::uint32_t open = 0;
    // By how much the angle inside the cell at its most concave edge exceeds 180 degrees, or 0.
    // Faces that lie in one plane, such as those of a finer neighbour, are not concave.
    double concavity = 0;
  };

  void clear()
  {
    edges_.clear();
    normals_.clear();
  }

  // An edge of a face, in the direction that is counter-clockwise from outside, and the face's
  // outward normal there, of any length.
  void add(std::uint32_t from, std::uint32_t to, const Vector& normal)
  {
    const auto number = static_cast<std::uint32_t>(normals_.size());
    edges_.push_back(from < to ? Edge{ from, to, true, number } : Edge{ to, from, false, number });
    normals_.push_back(normal);
  }

  // `position(point)`: a Vector. Where an edge joins more than two faces, those that follow each
  // other around it inside the cell belong together.
  template <class Position>
  Result measure(Position&& position);

private:
  struct Edge
  {
    std::uint32_t low;
    std::uint32_t high;
    bool ahead; // from low to high
    std::uint32_t normal;

    bool sameAs(const Edge& other) const { return low == other.low && high == other.high; }
  };

  void sort();
  Result measureGroup(std::size_t begin, std::size_t end, const Vector& along) const;

  std::vector<Edge> edges_;
  std::vector<Vector> normals_;
};

template <class Position>
CellEdges::Result CellEdges::measure(Position&& position)
{
  sort();
  Result result;
  std::size_t end = 0;
  for (std::size_t begin = 0; begin < edges_.size(); begin = end)
  {
    while (end < edges_.size() && edges_[end].sameAs(edges_[begin]))
    {
      ++end;
    }
    const Vector along = minus(position(edges_[begin].high), position(edges_[begin].low));
    const Result group = measureGroup(begin, end, along);
    result.open += group.open;
    result.concavity = std::max(result.concavity, group.concavity);
  }
  return result;
}

}
