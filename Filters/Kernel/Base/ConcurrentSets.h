// SPDX-License-Identifier: BSD-3-Clause
// Disjoint sets (DisjointSets.h) that any threads may unite at the same time. A number's parent only ever becomes lower:
// who still sees an old one sees another member of the set.
#pragma once

#include "Base/Execution.h"

#include <algorithm>
#include <atomic>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace cartesian
{

class ConcurrentSets
{
public:
  ConcurrentSets(std::size_t size, Execution& execution)
    : parent_(size)
  {
    constexpr std::size_t NumbersAChunk = 1 << 16;
    execution.forEach(size, NumbersAChunk, [&](std::size_t begin, std::size_t end) {
      for (std::size_t x = begin; x < end; ++x)
      {
        parent_[x].store(static_cast<std::uint32_t>(x), std::memory_order_relaxed);
      }
    });
  }

  // The lowest number of the set that holds x, once all unions are done.
  std::uint32_t find(std::uint32_t x)
  {
    for (std::uint32_t parent = parentOf(x); parent != x; parent = parentOf(x))
    {
      const std::uint32_t above = parentOf(parent);
      if (above != parent)
      {
        // Shortens the way; if another thread has, that will do.
        parent_[x].compare_exchange_weak(parent, above, std::memory_order_relaxed);
      }
      x = above;
    }
    return x;
  }

  void unite(std::uint32_t x, std::uint32_t y)
  {
    for (bool isDone = false; !isDone;)
    {
      x = find(x);
      y = find(y);
      std::uint32_t high = std::max(x, y); // still a root?
      isDone = x == y ||
        parent_[high].compare_exchange_strong(high, std::min(x, y), std::memory_order_relaxed);
    }
  }

private:
  std::uint32_t parentOf(std::uint32_t x) const
  {
    return parent_[x].load(std::memory_order_relaxed);
  }

  std::vector<std::atomic<std::uint32_t>> parent_;
};

}
