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

  // Borrows all three; `newNodes` is filled by find().
  PlaneSection(
    const Polyhedron& cell, const CutPlane& plane, std::vector<CellCut::NewNode>& newNodes)
    : cell_(cell)
    , plane_(plane)
    , newNodes_(newNodes)
  {
  }

  // False if all nodes are on one side of the plane, or rounding moves a new node onto an old one.
  bool find();

  // 1 above the plane, -1 below, 0 on it: as new nodes are.
  int sign(std::uint32_t node) const
  {
    return node < cell_.nodes.size() ? (distance_[node] > 0) - (distance_[node] < 0) : 0;
  }
  bool isOnPlane(std::uint32_t node) const
  {
    return node >= cell_.nodes.size() || distance_[node] == 0;
  }
  bool crosses(std::uint32_t from, std::uint32_t to) const { return sign(from) * sign(to) < 0; }

  const Vector& position(std::uint32_t node) const
  {
    return node < cell_.nodes.size() ? cell_.nodes[node] : newNodes_[node - cell_.nodes.size()].at;
  }

  // The new node on an edge, or NoNode.
  std::uint32_t newNodeOn(const Edge& edge) const;

  // Calls visit(from, to) for the edges of a face.
  template <class Visitor>
  void forEachEdge(std::size_t face, Visitor&& visit) const
  {
    std::uint32_t from = cell_.corners[cell_.start[face + 1] - 1];
    for (std::size_t i = cell_.start[face]; i < cell_.start[face + 1]; ++i)
    {
      visit(from, cell_.corners[i]);
      from = cell_.corners[i];
    }
  }

  static Edge edgeBetween(std::uint32_t from, std::uint32_t to)
  {
    return { std::min(from, to), std::max(from, to) };
  }

private:
  void findDistances();
  bool hasBothSides() const;
  Vector crossing(std::uint32_t from, std::uint32_t to) const;
  std::vector<std::pair<Edge, double>> sectionLengths() const;
  void snapNodes();
  bool addNewNodes();

  const Polyhedron& cell_;
  const CutPlane& plane_;
  std::vector<CellCut::NewNode>& newNodes_;
  std::vector<double> distance_; // of the cell's nodes from the plane; 0: on it
};

}
