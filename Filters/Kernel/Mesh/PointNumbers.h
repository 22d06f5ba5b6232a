// SPDX-License-Identifier: BSD-3-Clause
// Numbers of the points that cells use (section 6, step 11).
//
// Points are numbered row by row (Numbering.h). Each row has first the vertices of the global mesh, then
// other grid nodes, points of patches and nodes that edits added. Thus the numbers of a part's points
// (Decomposition.h) follow those of the part before.
#pragma once

#include "Cells/Boundary.h"
#include "Faces/UsedVertices.h"

namespace cartesian
{

class PointNumbers
{
public:
  // Numbers the points that cells in these layers of boxes use.
  PointNumbers(const MeshParts& parts, SlabRange layers, Execution& execution);

  std::size_t size() const { return rowStart_.back(); }

  // The first number in a layer of points; size() beyond the last layer.
  std::size_t firstOfLayer(std::size_t k) const;

  // The number of a node, or None if no cell uses it.
  std::uint32_t ofNode(std::size_t node) const { return ofNode_[node]; }

  // The number of a used vertex of the global mesh. Its neighbour i + 1 in the same box has the next.
  std::uint32_t ofVertex(std::uint32_t i, std::uint32_t j, std::uint32_t k) const
  {
    return static_cast<std::uint32_t>(rowStart_[j + k * rowLength_] + vertices_.rank(i, j, k));
  }

  // The same for vertices of the row j + k * (planes along y) that come in order.
  class Walk
  {
  public:
    Walk(const PointNumbers& numbers, std::size_t row)
      : first_(numbers.rowStart_[row])
      , ranks_(numbers.vertices_, row)
    {
    }

    std::uint32_t ofVertex(std::uint32_t i)
    {
      return static_cast<std::uint32_t>(first_ + ranks_.rank(i));
    }

  private:
    std::size_t first_;
    UsedVertices::Walk ranks_;
  };

  // Calls visit(number, i) for the used vertices of the row j + k * (planes along y), in order.
  template <class Visitor>
  void forEachVertex(std::size_t row, Visitor&& visit) const
  {
    vertices_.forEach(
      row, [&](std::size_t rank, std::uint32_t i) { visit(rowStart_[row] + rank, i); });
  }

private:
  struct AddedNode;

  PointNumbers(
    const MeshParts& parts, SlabRange layers, std::vector<NodeRole>&& roles, Execution& execution);

  // All used nodes are Plain.
  static std::vector<NodeRole> usedNodes(
    const MeshParts& parts, SlabRange layers, Execution& execution);
  static std::vector<AddedNode> addedNodes(
    const Nodes& nodes, const Meshlines& planes, const std::vector<NodeRole>& roles);
  template <class Visitor>
  void forEachGridNode(const Nodes& nodes, Execution& execution, Visitor&& visit) const;
  bool isVertex(const MeshParts& parts, std::size_t row, std::size_t node, std::uint32_t& i) const;
  void markVertices(
    const MeshParts& parts, std::vector<NodeRole>& roles, Execution& execution) const;
  void countPoints(const MeshParts& parts, const std::vector<NodeRole>& roles,
    const std::vector<AddedNode>& added, Execution& execution);
  void numberNodes(const MeshParts& parts, const std::vector<NodeRole>& roles,
    const std::vector<AddedNode>& added, Execution& execution);

  std::size_t rowLength_;
  UsedVertices vertices_;
  std::vector<std::size_t> rowStart_; // first number of each row, and the end
  std::vector<std::uint32_t> ofNode_;
};

}
