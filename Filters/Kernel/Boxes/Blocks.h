// SPDX-License-Identifier: BSD-3-Clause
// Blocks: an octree over the global boxes, while boxes are generated.
//
// A block is a cube, at first a global box, whose boxes are found at once: it divides the cube into
// units, and has a block of its own for each unit that must be divided further. Boxes are no larger
// than their block and at least as large as its units, until balance halves them.
#pragma once

#include "Boxes/Boxes.h"
#include "Boxes/Refinement.h"

#include <limits>

namespace cartesian
{

struct Block
{
  static constexpr std::int64_t Nowhere = std::numeric_limits<std::int64_t>::min() / 2;

  std::uint32_t global; // number of the global box
  Cube cube;
  int bits;                             // 2^bits units along each axis
  BoxStatus status;                     // of the whole cube
  int allowed = 0;                      // the depth where the surface passes
  Forcing forcing;                      // until its boxes are found
  Winding low;                          // around its low corner
  std::vector<std::uint32_t> triangles; // that pass through it, if it is a part of a global box
  std::vector<LocalBox> boxes;          // by z, then y, then x
  BoxTree tree;                         // of these boxes; child blocks are other trees
  FinePoint place{ Nowhere, Nowhere, Nowhere }; // of its low corner, once it is added
  std::uint32_t parent = None;
  std::uint32_t firstChild = 0; // in order of their units
  std::uint32_t children = 0;
  std::uint8_t coarsest = 0;  // the least level of its boxes
  std::uint8_t depth = 0;     // the largest level of its boxes and of those below
  std::uint8_t nearDepth = 0; // no less than of it and its 26 neighbours of this size
};

// The boxes of a grid by block. Global boxes without a block are one box.
class Blocks
{
public:
  // `grid`: what is around a block, beyond the ends of the grid too.
  Blocks(const Boxes& globals, const EndlessGrid& grid, Execution& execution);

  std::size_t size() const { return blocks_.size(); }
  Block& operator[](std::size_t b) { return blocks_[b]; }
  const Block& operator[](std::size_t b) const { return blocks_[b]; }

  // Of a global box, or None.
  std::uint32_t rootOf(std::size_t global) const { return roots_.empty() ? None : roots_[global]; }

  // Adds a block for a global box; returns its number.
  std::uint32_t addRoot(Block&& root);

  // Adds blocks below `parent`, in order of their units.
  void addChildren(std::uint32_t parent, std::vector<Block>&& children);

  // Sorts the boxes of these blocks, which have changed; finds trees and depths.
  void update(const std::vector<std::uint32_t>& changed);

  // The largest level of a global box and its 26 neighbours.
  std::uint8_t nearDepthOf(std::size_t global) const
  {
    return nearDepths_.empty() ? std::uint8_t(0) : nearDepths_[global];
  }

  // The levels of the box at a place of the fine grid, or null. `near`: a block near it, or one that is not there
  // yet; `size` receives that of the unit there, fine.
  const std::array<std::uint8_t, 3>* levelsAt(
    const FinePoint& fine, const Block& near, std::int64_t& size) const;

  // Calls visit(block) for a block and those below it, each before its children.
  template <class Visitor>
  void forEachBelow(std::uint32_t block, Visitor&& visit) const
  {
    visit(block);
    for (std::uint32_t child = 0; child < blocks_[block].children; ++child)
    {
      forEachBelow(blocks_[block].firstChild + child, visit);
    }
  }

private:
  FinePoint placeOf(const Block& block) const;
  const Block* blockAround(const FinePoint& fine, const Block& near) const;
  std::uint32_t globalAround(const FinePoint& fine, const Block& near) const;
  std::uint8_t depthOf(
    std::uint32_t global, const std::array<std::int64_t, 3>& low, int level) const;
  void findNearDepth(Block& block) const;
  void findNearDepths();

  const Boxes& globals_;
  EndlessGrid grid_;
  Execution& execution_;
  std::vector<std::uint32_t> roots_;     // of global boxes; empty: there are no blocks
  std::vector<std::uint8_t> nearDepths_; // of global boxes
  std::vector<Block> blocks_;
};

}
