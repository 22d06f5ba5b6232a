// SPDX-License-Identifier: BSD-3-Clause
// Where a cutting plane meets a cell: which nodes lie above, on and below it, and the new nodes on
// the edges that cross it.
#pragma once

#include "Polyhedra/PolyhedronCut.h"

#include <utility>

namespace cartesian
{

class PlaneSection
{
public:
  using Edge = std::pair<std::uint32_t, std::uint32_t>; // lower node first

  static constexpr std::uint32_t NoNode = ~std::uint32_t(0);

  // Borrows all three, up to the next call; fills `newNodes`. False if all nodes are on one side of the plane, or
  // rounding moves a new node onto an old one.
  bool find(const Polyhedron& cell, const CutPlane& plane, std::vector<CellCut::NewNode>& newNodes);

  // 1 above the plane, -1 below, 0 on it: as new nodes are.
  int sign(std::uint32_t node) const
  {
    return node < distance_.size() ? (distance_[node] > 0) - (distance_[node] < 0) : 0;
  }
  bool isOnPlane(std::uint32_t node) const { return sign(node) == 0; }
  bool crosses(std::uint32_t from, std::uint32_t to) const { return sign(from) * sign(to) < 0; }

  // Whether a face has nodes above and below.
  bool crosses(std::size_t face) const;

  const Vector& position(std::uint32_t node) const
  {
    return node < distance_.size() ? cell_->nodes[node] : (*newNodes_)[node - distance_.size()].at;
  }

  // The new node on an edge, or NoNode.
  std::uint32_t newNodeOn(const Edge& edge) const;

  // Calls visit(from, to) for the edges of a face.
  template <class Visitor>
  void forEachEdge(std::size_t face, Visitor&& visit) const
  {
    std::uint32_t from = cell_->corners[cell_->start[face + 1] - 1];
    for (std::size_t i = cell_->start[face]; i < cell_->start[face + 1]; ++i)
    {
      visit(from, cell_->corners[i]);
      from = cell_->corners[i];
    }
  }

  static Edge edgeBetween(std::uint32_t from, std::uint32_t to)
  {
    return { std::min(from, to), std::max(from, to) };
  }

private:
  void findDistances(const CutPlane& plane);
  bool hasBothSides() const;
  Vector crossing(std::uint32_t from, std::uint32_t to) const;
  void listLengths();
  void snapNodes();
  bool addNewNodes();

  const Polyhedron* cell_ = nullptr;
  std::vector<CellCut::NewNode>* newNodes_ = nullptr;
  std::vector<double> distance_; // of the cell's nodes from the plane; 0: on it
  std::vector<Vector> ends_;
  std::vector<std::pair<Edge, double>> lengths_;
  std::vector<std::uint32_t> snapped_;
};

}
