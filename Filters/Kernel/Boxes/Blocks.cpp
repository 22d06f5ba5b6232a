// SPDX-License-Identifier: BSD-3-Clause
#include "Boxes/Blocks.h"

#include <numeric>

namespace cartesian
{

namespace
{

constexpr std::size_t BlocksAChunk = 8;
constexpr std::array<std::uint8_t, 3> Undivided{ 0, 0, 0 };

bool isBefore(const LocalBox& a, const LocalBox& b)
{
  return std::lexicographical_compare(
    a.offset.rbegin(), a.offset.rend(), b.offset.rbegin(), b.offset.rend());
}

// From the boxes of a block and its children.
void plant(Block& block, const std::vector<Block>& blocks)
{
  std::vector<std::uint32_t> numbers(block.boxes.size());
  std::iota(numbers.begin(), numbers.end(), 0);
  block.tree.clear();
  block.tree.add(block.cube, block.bits, block.boxes.data(), numbers);
  const int shift = DeepestLevel - block.cube.level - block.bits;
  for (std::uint32_t child = block.firstChild; child < block.firstChild + block.children; ++child)
  {
    const Offset& at = blocks[child].cube.offset;
    block.tree.setContent(0,
      BoxTree::unitAt({ at[0] >> shift, at[1] >> shift, at[2] >> shift }, block.bits),
      BoxTree::NodeBit | BoxTree::OtherTree | child);
  }
}

void findLevels(Block& block)
{
  block.coarsest = DeepestLevel;
  for (const LocalBox& box : block.boxes)
  {
    const auto [least, most] = std::minmax({ box.level[0], box.level[1], box.level[2] });
    block.coarsest = std::min(block.coarsest, least);
    block.depth = std::max(block.depth, most);
  }
}

}

Blocks::Blocks(const Boxes& globals, const EndlessGrid& grid, Execution& execution)
  : globals_(globals)
  , grid_(grid)
  , execution_(execution)
{
}

FinePoint Blocks::placeOf(const Block& block) const
{
  FinePoint place;
  for (std::size_t axis = 0; axis < 3; ++axis)
  {
    place[axis] = globals_.globals[block.global].index[axis] * FinePerBox + block.cube.offset[axis];
  }
  return place;
}

std::uint32_t Blocks::addRoot(Block&& root)
{
  root.place = placeOf(root);
  const auto number = static_cast<std::uint32_t>(blocks_.size());
  if (roots_.empty())
  {
    roots_.assign(globals_.globals.size() - 1, None);
  }
  roots_[root.global] = number;
  blocks_.push_back(std::move(root));
  return number;
}

void Blocks::addChildren(std::uint32_t parent, std::vector<Block>&& children)
{
  blocks_[parent].firstChild = static_cast<std::uint32_t>(blocks_.size());
  blocks_[parent].children = static_cast<std::uint32_t>(children.size());
  for (Block& child : children)
  {
    child.parent = parent;
    child.place = placeOf(child);
  }
  std::move(children.begin(), children.end(), std::back_inserter(blocks_));
}

void Blocks::update(const std::vector<std::uint32_t>& changed)
{
  execution_.forEach(changed.size(), BlocksAChunk, [&](std::size_t begin, std::size_t end) {
    for (std::size_t i = begin; i < end; ++i)
    {
      Block& block = blocks_[changed[i]];
      std::sort(block.boxes.begin(), block.boxes.end(), isBefore);
      plant(block, blocks_);
      findLevels(block);
    }
  });
  for (std::size_t b = blocks_.size(); b-- > 0;) // children come after their parents
  {
    for (std::uint32_t child = 0; child < blocks_[b].children; ++child)
    {
      blocks_[b].depth = std::max(blocks_[b].depth, blocks_[blocks_[b].firstChild + child].depth);
    }
  }
  findNearDepths();
}

void Blocks::findNearDepths()
{
  nearDepths_ = largestAround(
    globals_, grid_,
    [&](std::size_t g) { return rootOf(g) == None ? std::uint8_t(0) : blocks_[roots_[g]].depth; },
    execution_);
  execution_.forEach(blocks_.size(), BlocksAChunk, [&](std::size_t begin, std::size_t end) {
    for (std::size_t b = begin; b < end; ++b)
    {
      findNearDepth(blocks_[b]);
    }
  });
}

void Blocks::findNearDepth(Block& block) const
{
  if (block.cube.level == 0)
  {
    block.nearDepth = nearDepths_[block.global];
    return;
  }
  block.nearDepth = block.depth;
  const auto& index = globals_.globals[block.global].index;
  for (std::int64_t n = 0; n < 27; ++n)
  {
    const std::array<std::int64_t, 3> side = { n % 3 - 1, n / 3 % 3 - 1, n / 9 - 1 };
    std::array<std::int64_t, 3> low;
    std::array<std::int64_t, 3> global;
    bool isSame = true;
    for (std::size_t axis = 0; axis < 3; ++axis)
    {
      low[axis] = block.cube.offset[axis] + side[axis] * block.cube.size();
      const std::int64_t beyond = low[axis] < 0 ? -1 : (low[axis] >= FinePerBox ? 1 : 0);
      global[axis] = index[axis] + beyond;
      low[axis] -= beyond * FinePerBox;
      isSame = isSame && beyond == 0;
    }
    global = grid_.seen(global);
    const std::uint32_t g =
      isSame ? block.global : globals_.globalAt(global[0], global[1], global[2]);
    if (g != None)
    {
      block.nearDepth = std::max(block.nearDepth, depthOf(g, low, block.cube.level));
    }
  }
}

// No less than the largest level in a cube of a global box.
std::uint8_t Blocks::depthOf(
  std::uint32_t global, const std::array<std::int64_t, 3>& low, int level) const
{
  if (rootOf(global) == None)
  {
    return 0;
  }
  const Block* block = &blocks_[roots_[global]];
  for (;;)
  {
    const int shift = DeepestLevel - block->cube.level - block->bits;
    if (block->cube.level + block->bits > level)
    {
      return block->depth;
    }
    const std::uint32_t content = block->tree.content(
      0, BoxTree::unitAt({ low[0] >> shift, low[1] >> shift, low[2] >> shift }, block->bits));
    if (!BoxTree::isNode(content))
    {
      const auto deepest = [](const LocalBox& box) {
        return std::max({ box.level[0], box.level[1], box.level[2] });
      };
      return content == None ? std::uint8_t(0) : deepest(block->boxes[content]);
    }
    if (!BoxTree::isOtherTree(content))
    {
      return block->depth;
    }
    block = &blocks_[BoxTree::treeAt(content)];
  }
}

std::uint32_t Blocks::globalAround(const FinePoint& fine, const Block& near) const
{
  const auto [i, j, k] =
    grid_.seen({ fine[0] >> DeepestLevel, fine[1] >> DeepestLevel, fine[2] >> DeepestLevel });
  const auto& guess = globals_.globals[near.global].index;
  const bool hit = guess[0] == i && guess[1] == j && guess[2] == k;
  return hit ? near.global : globals_.globalAt(i, j, k);
}

// The smallest of a block and those that it is in that contains a place, else the root there, or null.
const Block* Blocks::blockAround(const FinePoint& fine, const Block& near) const
{
  const Block* block = &near;
  for (;;)
  {
    const auto offset = [&](std::size_t axis) {
      return static_cast<std::uint64_t>(fine[axis] - block->place[axis]);
    };
    // Offsets below 0 are very large.
    if ((offset(0) | offset(1) | offset(2)) < static_cast<std::uint64_t>(block->cube.size()))
    {
      return block;
    }
    if (block->parent == None)
    {
      break;
    }
    block = &blocks_[block->parent];
  }
  const std::uint32_t g = globalAround(fine, near);
  return g == None || rootOf(g) == None ? nullptr : &blocks_[roots_[g]];
}

const std::array<std::uint8_t, 3>* Blocks::levelsAt(
  const FinePoint& fine, const Block& near, std::int64_t& size) const
{
  const Block* block = blockAround(fine, near);
  if (block == nullptr)
  {
    size = FinePerBox;
    return globalAround(fine, near) == None ? nullptr : &Undivided;
  }
  std::uint32_t node = 0;
  int shift = DeepestLevel - block->cube.level;
  for (;;)
  {
    const int bits = block->tree.bitsOf(node);
    shift -= bits;
    const std::uint32_t content = block->tree.content(
      node, BoxTree::unitAt({ fine[0] >> shift, fine[1] >> shift, fine[2] >> shift }, bits));
    if (!BoxTree::isNode(content))
    {
      size = std::int64_t(1) << shift;
      return content == None ? nullptr : &block->boxes[content].level;
    }
    const bool isOther = BoxTree::isOtherTree(content);
    node = isOther ? 0 : BoxTree::nodeAt(content);
    block = isOther ? &blocks_[BoxTree::treeAt(content)] : block;
  }
}

}
