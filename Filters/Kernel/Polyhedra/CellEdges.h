// SPDX-License-Identifier: BSD-3-Clause
// Checks a cell edge by edge: is it closed, and how concave is it?
#pragma once

#include "Lattice/Vector.h"

#include <cstdint>
#include <vector>

namespace cartesian
{

// Takes cells one by one; keeps its storage.
class CellEdges
{
public:
  struct Result
  {
    // Edges that not as many faces use in one direction as in the other: the cell has a gap there.
    std::uint32_t open = 0;
    // By how many degrees the dihedral angle at the most concave edge exceeds 180, or 0. Coplanar
    // faces, such as those of a finer neighbour, are not concave.
    double concavity = 0;
  };

  void clear()
  {
    edges_.clear();
    normals_.clear();
  }

  // Adds an edge of a face, in the direction that is counter-clockwise from outside, with the face's
  // outward normal there, of any length.
  void add(std::uint32_t from, std::uint32_t to, const Vector& normal)
  {
    const auto number = static_cast<std::uint32_t>(normals_.size());
    edges_.push_back(from < to ? Edge{ from, to, true, number } : Edge{ to, from, false, number });
    normals_.push_back(normal);
  }

  // `position(point)`: a Vector. Where more than two faces meet at an edge, those that are
  // consecutive around it inside the cell are paired.
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
