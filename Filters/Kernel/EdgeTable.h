// A number for each edge between two nodes, and for each of its two sides: a table with open addressing
// that keeps its storage from use to use.
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

namespace cartesian
{

class EdgeTable
{
public:
  static constexpr std::uint32_t Fresh = ~std::uint32_t(0);

  // Empty, for at most as many edges.
  void reset(std::size_t edges)
  {
    std::size_t size = 16;
    while (size < 2 * edges)
    {
      size *= 2;
    }
    entries_.assign(size, { 0, 0, Free, Fresh });
  }

  // Fresh where nobody has set it yet.
  std::uint32_t& at(std::uint32_t lower, std::uint32_t upper, std::uint32_t side = 0)
  {
    constexpr std::uint64_t Golden = 0x9e3779b97f4a7c15u;
    const std::uint64_t bits = (std::uint64_t(lower) << 32 | upper) + side;
    const std::size_t mask = entries_.size() - 1;
    for (std::size_t i = bits * Golden >> 32;; ++i)
    {
      Entry& entry = entries_[i & mask];
      if (entry.side == Free)
      {
        entry = { lower, upper, side, Fresh };
        return entry.number;
      }
      if (entry.lower == lower && entry.upper == upper && entry.side == side)
      {
        return entry.number;
      }
    }
  }

private:
  static constexpr std::uint32_t Free = 2; // else 0 or 1

  struct Entry
  {
    std::uint32_t lower;
    std::uint32_t upper;
    std::uint32_t side;
    std::uint32_t number;
  };
  std::vector<Entry> entries_;
};

}
