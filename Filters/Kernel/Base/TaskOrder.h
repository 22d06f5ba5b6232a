// SPDX-License-Identifier: BSD-3-Clause
// Tasks of which some must end before others begin: gives them to threads as soon as that is so.
#pragma once

#include <atomic>
#include <condition_variable>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <mutex>
#include <queue>
#include <vector>

namespace cartesian
{

class TaskOrder
{
public:
  static constexpr std::uint32_t None = ~std::uint32_t(0);

  // Of each task, those that must end before it begins: lower numbers, ascending.
  using After = std::vector<std::vector<std::uint32_t>>;

  explicit TaskOrder(const After& after);

  // The lowest task that may begin, now or within so many seconds; None: there is none.
  std::uint32_t begin(double seconds);
  void end(std::uint32_t task);

  // No more tasks begin.
  void cancel();

  bool haveAllBegun() const { return left_ == 0; }
  std::size_t ended() const { return ended_; }

private:
  std::mutex mutex_; // of all below
  std::condition_variable changed_;
  std::vector<std::vector<std::uint32_t>> before_; // of each task: which wait for it
  std::vector<std::uint32_t> waitsFor_;            // how many
  std::priority_queue<std::uint32_t, std::vector<std::uint32_t>, std::greater<>> ready_;
  std::atomic<std::size_t> left_; // to begin
  std::atomic<std::size_t> ended_{ 0 };
};

}
