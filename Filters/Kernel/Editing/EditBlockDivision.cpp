// SPDX-License-Identifier: BSD-3-Clause
#include "Editing/EditBlockDivision.h"

#include "Base/Sorting.h"

#include <algorithm>
#include <numeric>
#include <tuple>

namespace cartesian
{

namespace
{

using Numbers = std::vector<std::uint32_t>;
constexpr std::size_t BlocksAChunk = 8;

std::uint32_t coloursAlong(std::uint32_t width, std::uint32_t reach)
{
  return 1 + (2 * reach + width - 1) / width;
}

// Of a block and one of its boxes: in order.
struct Keyed
{
  std::uint32_t colour;
  std::uint32_t level; // of its boxes
  std::array<std::uint32_t, 3> cube;
  AskedBox asked;

  auto block() const { return std::tie(colour, level, cube[2], cube[1], cube[0]); }
  bool operator<(const Keyed& other) const
  {
    return block() != other.block() ? block() < other.block() : asked.box < other.asked.box;
  }
};

// Colours begin with `first`.
Keyed keyOf(const AskedBox& asked, const BoxPlace& place, std::uint32_t width, std::uint32_t reach,
  std::uint32_t first)
{
  const std::uint32_t along = coloursAlong(width, reach);
  Keyed key{ 0, place.level, {}, asked };
  for (std::size_t axis = 3; axis-- > 0;)
  {
    key.cube[axis] = place.at[axis] / width;
    key.colour = key.colour * along + key.cube[axis] % along;
  }
  key.colour += first;
  return key;
}

// Calls visit(begin, end) for each block.
template <class Visitor>
void forEachBlock(const std::vector<Keyed>& keys, Visitor&& visit)
{
  for (auto begin = keys.begin(); begin != keys.end();)
  {
    const auto end = std::find_if(
      begin, keys.end(), [&](const Keyed& key) { return key.block() != begin->block(); });
    visit(begin, end);
    begin = end;
  }
}

std::vector<EditBlock> blocksOf(const std::vector<BoxPlace>& places,
  const std::vector<AskedBox>& asked, const EditBlockSize& size, Execution& execution)
{
  std::vector<Keyed> keys(asked.size());
  std::transform(asked.begin(), asked.end(), keys.begin(),
    [&](const AskedBox& one) { return keyOf(one, places[one.box], size.width, size.reach, 0); });
  sortAll(keys, execution);
  std::vector<Keyed> divided;
  const std::uint32_t along = coloursAlong(size.width, size.reach);
  forEachBlock(keys, [&](auto begin, auto end) {
    const std::uint64_t weight = std::accumulate(begin, end, std::uint64_t(0),
      [](std::uint64_t sum, const Keyed& key) { return sum + key.asked.weight; });
    std::transform(begin, end, std::back_inserter(divided), [&](const Keyed& key) {
      return weight <= size.mostWeight ? key
                                       : keyOf(key.asked, places[key.asked.box], size.width / 2,
                                           size.reach, along * along * along);
    });
  });
  sortAll(divided, execution);
  std::vector<EditBlock> blocks;
  forEachBlock(divided, [&](auto begin, auto end) {
    blocks.emplace_back();
    std::transform(begin, end, std::back_inserter(blocks.back().own),
      [](const Keyed& key) { return key.asked.box; });
  });
  return blocks;
}

struct ZoneSearch
{
  Marks seen; // boxes
  Marks nodes;
  Numbers beside;
};

void findZone(EditBlock& block, const EditBlockSize& size, const Beside& beside, ZoneSearch& search)
{
  search.seen.begin();
  for (const std::uint32_t box : block.own)
  {
    search.seen.mark(box);
  }
  block.zone = block.own;
  std::size_t next = 0;
  for (std::uint32_t ring = 0; ring < size.reach; ++ring)
  {
    for (const std::size_t end = block.zone.size(); next < end; ++next)
    {
      search.beside.clear();
      beside(block.zone[next], search.nodes, search.beside);
      std::copy_if(search.beside.begin(), search.beside.end(), std::back_inserter(block.zone),
        [&](std::uint32_t box) { return search.seen.mark(box); });
    }
  }
}

// Of each block, the earlier ones that have boxes of its zone.
std::vector<Numbers> conflicts(
  const std::vector<EditBlock>& blocks, std::size_t boxes, Execution& execution)
{
  const auto blocksOf = fillBuckets<std::uint32_t>(
    blocks.size(), BlocksAChunk, boxes,
    [&](std::size_t begin, std::size_t end, auto&& add) {
      for (std::size_t b = begin; b < end; ++b)
      {
        for (const std::uint32_t box : blocks[b].zone)
        {
          add(box, static_cast<std::uint32_t>(b));
        }
      }
    },
    execution);
  std::vector<Numbers> after(blocks.size());
  execution.forEach(blocks.size(), BlocksAChunk, [&](std::size_t begin, std::size_t end) {
    Marks seen;
    for (std::size_t b = begin; b < end; ++b)
    {
      seen.begin();
      for (const std::uint32_t box : blocks[b].zone)
      {
        for (const std::uint32_t* other = blocksOf.begin(box); *other < b; ++other)
        {
          seen.mark(*other) ? after[b].push_back(*other) : void();
        }
      }
      std::sort(after[b].begin(), after[b].end());
    }
  });
  return after;
}

}

EditBlockDivision divideIntoEditBlocks(const std::vector<BoxPlace>& places,
  const std::vector<AskedBox>& asked, const EditBlockSize& size, const Beside& beside,
  Execution& execution)
{
  EditBlockDivision result{ blocksOf(places, asked, size, execution), {} };
  execution.forEach(result.blocks.size(), BlocksAChunk, [&](std::size_t begin, std::size_t end) {
    ZoneSearch search;
    for (std::size_t b = begin; b < end; ++b)
    {
      findZone(result.blocks[b], size, beside, search);
    }
  });
  result.after = conflicts(result.blocks, places.size(), execution);
  return result;
}

}
