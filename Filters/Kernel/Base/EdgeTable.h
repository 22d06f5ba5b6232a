// SPDX-License-Identifier: BSD-3-Clause
// A hash table (open addressing) from an edge between two nodes, and one of its two sides, to a
// number. A single node counts as an edge to itself. The table keeps its storage from use to use.
#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace cartesian
{

class EdgeTable
{
public:
  static constexpr std::uint32_t Fresh = ~std::uint32_t(0);

  // Empties the table and makes room for this many edges. Few of them stay close together in what may be a large storage.
  void reset(std::size_t edges)
  {
    std::size_t size = 16;
    while (size < 2 * edges)
    {
      size *= 2;
    }
    mask_ = size - 1;
    if (size > entries_.size() || ++use_ == LastUse)
    {
      entries_.assign(std::max(size, entries_.size()), { 0, 0, 0, 0 });
      use_ = 1;
    }
  }

  // The edge's number; Fresh if it has not been set yet.
  std::uint32_t& at(std::uint32_t lower, std::uint32_t upper, std::uint32_t side = 0)
  {
    constexpr std::uint64_t Golden = 0x9e3779b97f4a7c15u;
    const std::uint64_t bits = (std::uint64_t(lower) << 32 | upper) + side;
    const std::uint32_t useAndSide = use_ << 1 | side;
    for (std::size_t i = bits * Golden >> 32;; ++i)
    {
      Entry& entry = entries_[i & mask_];
      if (entry.useAndSide >> 1 != use_)
      {
        entry = { lower, upper, useAndSide, Fresh };
        return entry.number;
      }
      if (entry.lower == lower && entry.upper == upper && entry.useAndSide == useAndSide)
      {
        return entry.number;
      }
    }
  }

private:
  static constexpr std::uint32_t LastUse = ~std::uint32_t(0) >> 1;

  struct Entry
  {
    std::uint32_t lower;
    std::uint32_t upper;
    std::uint32_t useAndSide; // the entry is free if this is from another use
    std::uint32_t number;
  };
  std::vector<Entry> entries_;
  std::size_t mask_ = 0;  // of the part in use
  std::uint32_t use_ = 0; // uses since the entries were cleared
};

}
