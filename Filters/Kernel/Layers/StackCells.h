// SPDX-License-Identifier: BSD-3-Clause
// Of which cells the stack on a face consists.
//
// A node has so many layers as fit above it. As far as all nodes of a face have them, each is a cell; what is above these is
// one more, which is thinner towards nodes that have fewer: slices of a wedge are so skew that solvers diverge on them.
//
// Layers are counted from the mesh as if all were there: the first is that farthest from the wall.
#pragma once

#include "Layers/LayerHeights.h"
#include "Layers/LayeredWall.h"

namespace cartesian
{

class StackCells
{
public:
  // Borrows the wall.
  StackCells(const LayeredWall& wall, const LayerHeights& heights, Execution& execution);

  std::size_t layers() const { return layers_; }

  // Above a node.
  std::size_t layersAt(std::size_t node) const { return counts_[node]; }

  std::size_t cells(std::size_t face) const
  {
    return regular_[face] + (regular_[face] < most_[face] ? 1 : 0);
  }
  bool hasRegular(std::size_t face) const { return regular_[face] > 0; } // below what differs
  bool isWhole(std::size_t face) const { return regular_[face] == layers_; }

  // The layers that its k-th cell takes.
  std::size_t begin(std::size_t face, std::size_t k) const;
  std::size_t end(std::size_t face, std::size_t k) const { return endAt(face, begin(face, k)); }

  // Whether a side over the face's edge from corner i begins with a layer that the face has, and where it ends: where a cell of
  // either face at the edge does.
  bool isSideAt(std::size_t face, std::size_t i, std::size_t layer) const;
  std::size_t endOfSide(std::size_t face, std::size_t i, std::size_t layer) const;

private:
  void count(std::size_t face, const LayerHeights& heights);
  std::size_t first(std::size_t face) const { return layers_ - most_[face]; }
  bool beginsAt(std::size_t face, std::size_t layer) const;
  std::size_t endAt(std::size_t face, std::size_t layer) const;
  std::size_t beyond(std::size_t face, std::size_t i) const;

  const LayeredWall& wall_;
  const std::size_t layers_;
  std::vector<std::uint8_t> counts_;  // of each node
  std::vector<std::uint8_t> most_;    // of each face's nodes
  std::vector<std::uint8_t> regular_; // ... layers that are cells
};

}
