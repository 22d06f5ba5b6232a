// SPDX-License-Identifier: BSD-3-Clause
// Which nodes of a graph edges connect.
#pragma once

#include "Base/Execution.h"

#include <cstddef>
#include <cstdint>
#include <numeric>
#include <vector>

namespace cartesian
{

class EdgeGraph
{
public:
  // forEachEdge(visit) calls visit(from, to) for edges from one of so many nodes to anything, in any order and any number of times
  // each; it runs twice.
  template <class ForEachEdge>
  EdgeGraph(std::size_t nodes, const ForEachEdge& forEachEdge, Execution& execution)
    : first_(nodes + 1)
  {
    forEachEdge([&](std::size_t from, std::uint32_t) { ++first_[from + 1]; });
    std::partial_sum(first_.begin(), first_.end(), first_.begin());
    to_.resize(first_.back());
    std::vector<std::size_t> next(first_.begin(), first_.end() - 1);
    forEachEdge([&](std::size_t from, std::uint32_t to) { to_[next[from]++] = to; });
    leaveOutTwins(execution);
  }

  std::size_t nodes() const { return first_.size() - 1; }
  std::size_t edges() const { return to_.size(); }

  // Those from a node are numbered consecutively.
  std::size_t first(std::size_t node) const { return first_[node]; }
  std::size_t end(std::size_t node) const { return first_[node + 1]; }
  std::uint32_t to(std::size_t edge) const { return to_[edge]; } // ascending

  const std::vector<std::size_t>& firsts() const { return first_; } // and the end

private:
  void leaveOutTwins(Execution& execution);

  std::vector<std::size_t> first_;
  std::vector<std::uint32_t> to_;
};

}
