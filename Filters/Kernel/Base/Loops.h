// SPDX-License-Identifier: BSD-3-Clause
// Separates closed walks over numbered nodes into simple loops.
#pragma once

#include <algorithm>
#include <cstdint>
#include <vector>

namespace cartesian
{

// Separates a closed walk into loops that visit no node twice, and calls visit(begin, end) for
// those with at least three nodes: a loop of two runs back and forth and bounds nothing. Overwrites
// `walk`.
template <class Visitor>
void forEachSimpleLoop(std::vector<std::uint32_t>& walk, Visitor&& visit)
{
  std::size_t size = 0;
  for (const std::uint32_t node : walk)
  {
    const auto end = walk.begin() + static_cast<std::ptrdiff_t>(size);
    const auto before = std::find(walk.begin(), end, node);
    if (before != end)
    {
      if (end - before > 2)
      {
        visit(&*before, &*before + (end - before));
      }
      size = static_cast<std::size_t>(before - walk.begin());
    }
    walk[size++] = node;
  }
  if (size > 2)
  {
    visit(walk.data(), walk.data() + size);
  }
}

}
