// SPDX-License-Identifier: BSD-3-Clause
// Separates closed walks over numbered nodes into simple loops.
#pragma once

#include <algorithm>
#include <cstdint>
#include <vector>

namespace cartesian
{

// Where the nodes of a walk last were. Short walks are searched; for long ones, that takes too long.
class PlacesInWalk
{
public:
  explicit PlacesInWalk(const std::vector<std::uint32_t>& walk)
  {
    constexpr std::size_t LongWalk = 64;
    if (walk.size() > LongWalk)
    {
      sorted_ = walk;
      std::sort(sorted_.begin(), sorted_.end());
      placeOf_.resize(sorted_.size());
    }
  }

  // The node's place among the first `size` of the walk, whose nodes are distinct, or `size`: there it is put.
  std::size_t put(std::vector<std::uint32_t>& walk, std::size_t size, std::uint32_t node)
  {
    std::size_t before = size;
    if (sorted_.empty())
    {
      const auto end = walk.begin() + static_cast<std::ptrdiff_t>(size);
      before = static_cast<std::size_t>(std::find(walk.begin(), end, node) - walk.begin());
    }
    else
    {
      std::size_t& place = placeOf_[static_cast<std::size_t>(
        std::lower_bound(sorted_.begin(), sorted_.end(), node) - sorted_.begin())];
      before = place < size && walk[place] == node ? place : size;
      place = before;
    }
    walk[before] = node;
    return before;
  }

private:
  std::vector<std::uint32_t> sorted_;
  std::vector<std::size_t> placeOf_; // of the nodes in that order; of those that are gone, anything
};

// Separates a closed walk into loops that visit no node twice, and calls visit(begin, end) for
// those with at least three nodes: a loop of two runs back and forth and bounds nothing. Overwrites
// `walk`.
template <class Visitor>
void forEachSimpleLoop(std::vector<std::uint32_t>& walk, Visitor&& visit)
{
  PlacesInWalk places(walk);
  std::size_t size = 0;
  for (const std::uint32_t node : walk)
  {
    const std::size_t before = places.put(walk, size, node);
    if (size - before > 2)
    {
      visit(walk.data() + before, walk.data() + size);
    }
    size = before + 1;
  }
  if (size > 2)
  {
    visit(walk.data(), walk.data() + size);
  }
}

}
