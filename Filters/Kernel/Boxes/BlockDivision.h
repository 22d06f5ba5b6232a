// SPDX-License-Identifier: BSD-3-Clause
// Divides blocks into boxes (section 4.5), tier by tier.
//
// All blocks of a tier are divided independently of each other, into the fewest boxes (FewestBoxes.h); units that
// must be divided further become the blocks of the next tier, with the triangles that pass through them. For depths
// of up to BoxTree::MostBits a global box has a single block: the fewest boxes of all.
#pragma once

#include "Boxes/Blocks.h"
#include "Boxes/GlobalStatuses.h"

namespace cartesian
{

// Of a block, or a global box without one.
TriangleRange trianglesOf(const Block& block, const Boxes& globals, const Shoeboxes& shoeboxes);

class BlockDivision
{
public:
  // Borrows all arguments. `isotropic`: boxes are halved along all axes alike.
  BlockDivision(const Surface& surface, const Boxes& globals, const Shoeboxes& shoeboxes,
    bool isotropic, Execution& execution);

  // Divides the blocks, which are roots, and all below them.
  void divide(Blocks& blocks) const;

private:
  struct Scratch;
  void divide(Block& block, std::vector<Block>& children, Scratch& scratch) const;
  void search(Block& block, Scratch& scratch) const;
  static Block childOf(const Block& block, std::uint32_t unit, Scratch& scratch);

  const Surface& surface_;
  const Boxes& globals_;
  const Shoeboxes& shoeboxes_;
  bool isotropic_;
  Execution& execution_;
};

}
