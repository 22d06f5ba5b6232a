// SPDX-License-Identifier: BSD-3-Clause
// Disjoint sets (union-find) of the numbers 0 to n - 1. The lowest number of a set represents it,
// so that the result does not depend on the order of unions.
#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <numeric>
#include <vector>

namespace cartesian
{

// The same in any array of numbers, each at first its own.
template <class Parents>
std::uint32_t rootOf(Parents&& parent, std::uint32_t x)
{
  while (parent[x] != x)
  {
    parent[x] = parent[parent[x]];
    x = parent[x];
  }
  return x;
}

// Whether they were separate.
template <class Parents>
bool uniteIn(Parents&& parent, std::uint32_t x, std::uint32_t y)
{
  const std::uint32_t rootX = rootOf(parent, x);
  const std::uint32_t rootY = rootOf(parent, y);
  parent[std::max(rootX, rootY)] = std::min(rootX, rootY);
  return rootX != rootY;
}

class DisjointSets
{
public:
  explicit DisjointSets(std::size_t size = 0) { reset(size); }

  // Each number becomes a separate set. Keeps the storage.
  void reset(std::size_t size)
  {
    parent_.resize(size);
    std::iota(parent_.begin(), parent_.end(), 0);
  }

  // The next number, as a separate set.
  void add() { parent_.push_back(static_cast<std::uint32_t>(parent_.size())); }

  // The lowest number of the set that holds x.
  std::uint32_t find(std::uint32_t x) { return rootOf(parent_, x); }

  // Returns the lowest number of the united set.
  std::uint32_t unite(std::uint32_t x, std::uint32_t y)
  {
    uniteIn(parent_, x, y);
    return find(x);
  }

private:
  std::vector<std::uint32_t> parent_;
};

}
