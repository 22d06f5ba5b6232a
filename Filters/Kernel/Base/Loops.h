// SPDX-License-Identifier: BSD-3-Clause
// Closed walks over numbered nodes.
#pragma once

#include <algorithm>
#include <cstdint>
#include <vector>

namespace cartesian
{

// Takes a closed walk apart into loops that visit no node twice, and calls visit(begin, end) for
// those of three nodes or more. Loops of two run to and fro: they bound nothing. `walk` is used up.
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
