// SPDX-License-Identifier: BSD-3-Clause
#include "Boxes/BlockDivision.h"

#include "Boxes/FewestBoxes.h"

#include <numeric>

namespace cartesian
{

namespace
{

constexpr std::size_t BlocksAChunk = 4;

// All units of a block alike, which nothing passes through.
void divideEvenly(Block& block)
{
  const auto level = static_cast<std::uint8_t>(block.cube.level + block.bits);
  for (std::size_t unit = 0; unit < std::size_t(1) << 3 * block.bits; ++unit)
  {
    block.boxes.push_back({ block.cube.part(block.bits, unit).offset, { level, level, level },
      BoxStatus::Inside, AllCorners });
  }
}

}

TriangleRange trianglesOf(const Block& block, const Boxes& globals, const Shoeboxes& shoeboxes)
{
  if (block.cube.level > 0)
  {
    return { block.triangles.data(), block.triangles.data() + block.triangles.size() };
  }
  const auto& [i, j, k] = globals.globals[block.global].index;
  return shoeboxes.triangles(globals.row(j, k), i);
}

struct BlockDivision::Scratch
{
  explicit Scratch(bool isotropic)
    : search(isotropic)
  {
  }

  FewestBoxes search;
  UnitStatuses statuses;
  ForcingScratch forcing;
  std::vector<BoxStatus> units;
  std::vector<std::uint8_t> forced;
  std::vector<std::uint32_t> toDivide; // units
};

BlockDivision::BlockDivision(const Surface& surface, const Boxes& globals,
  const Shoeboxes& shoeboxes, bool isotropic, Execution& execution)
  : surface_(surface)
  , globals_(globals)
  , shoeboxes_(shoeboxes)
  , isotropic_(isotropic)
  , execution_(execution)
{
}

void BlockDivision::divide(Blocks& blocks) const
{
  std::size_t begin = 0;
  while (begin < blocks.size())
  {
    const std::size_t count = blocks.size() - begin;
    std::vector<std::vector<Block>> children(count);
    execution_.nextLoop(0.6);
    execution_.forEach(count, BlocksAChunk, [&](std::size_t first, std::size_t end) {
      Scratch scratch(isotropic_);
      for (std::size_t b = first; b < end; ++b)
      {
        execution_.poll();
        divide(blocks[begin + b], children[b], scratch);
      }
    });
    for (std::size_t b = 0; b < count; ++b)
    {
      blocks.addChildren(static_cast<std::uint32_t>(begin + b), std::move(children[b]));
    }
    begin += count;
  }
  std::vector<std::uint32_t> all(blocks.size());
  std::iota(all.begin(), all.end(), 0);
  blocks.update(all);
}

void BlockDivision::divide(Block& block, std::vector<Block>& children, Scratch& scratch) const
{
  const bool isEven = block.status == BoxStatus::Inside && block.forcing.regions.empty() &&
    block.forcing.octants.first == block.forcing.octants.second;
  scratch.toDivide.clear();
  if (isEven && block.forcing.least == block.cube.level + block.bits)
  {
    divideEvenly(block);
  }
  else
  {
    search(block, scratch);
  }
  std::sort(scratch.toDivide.begin(), scratch.toDivide.end());
  children.reserve(scratch.toDivide.size());
  for (const std::uint32_t unit : scratch.toDivide)
  {
    children.push_back(childOf(block, unit, scratch));
  }
  block.forcing = {};
}

void BlockDivision::search(Block& block, Scratch& scratch) const
{
  const auto& index = globals_.globals[block.global].index;
  Refinement::forcedOfUnits(
    block.forcing, index, block.cube, block.bits, scratch.forcing, scratch.forced);
  const bool isCut = block.status == BoxStatus::Intersected;
  if (isCut)
  {
    scratch.statuses.compute(surface_, trianglesOf(block, globals_, shoeboxes_), globals_.planes,
      index, block.cube, block.bits, block.low);
    scratch.statuses.sortPassing();
  }
  scratch.units.assign(scratch.forced.size(), block.status);
  scratch.search.search(block.cube, block.bits, block.allowed,
    isCut ? scratch.statuses.units() : scratch.units, scratch.forced);
  scratch.search.collect(block.boxes, scratch.toDivide);
  for (LocalBox& box : block.boxes)
  {
    box.corners = isCut ? scratch.statuses.corners(box) : AllCorners;
  }
}

Block BlockDivision::childOf(const Block& block, std::uint32_t unit, Scratch& scratch)
{
  Block child;
  child.global = block.global;
  child.cube = block.cube.part(block.bits, unit);
  child.allowed = block.allowed;
  child.status = block.status;
  child.forcing =
    Refinement::forcingOfUnit(block.forcing, block.cube, block.bits, unit, scratch.forcing);
  int deepest = scratch.forced.empty() ? block.forcing.least : scratch.forced[unit];
  if (block.status == BoxStatus::Intersected)
  {
    child.status = scratch.statuses.units()[unit];
    child.low = scratch.statuses.lowOf(unit);
  }
  if (child.status == BoxStatus::Intersected)
  {
    child.triangles = scratch.statuses.trianglesIn(unit);
    deepest = std::max(deepest, child.allowed);
  }
  child.bits = BoxTree::bitsFor(deepest, child.cube.level);
  return child;
}

}
