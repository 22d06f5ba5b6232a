// SPDX-License-Identifier: BSD-3-Clause
#include "Base/TaskOrder.h"

#include <chrono>

namespace cartesian
{

TaskOrder::TaskOrder(const After& after)
  : before_(after.size())
  , left_(after.size())
{
  for (std::uint32_t task = 0; task < after.size(); ++task)
  {
    waitsFor_.push_back(static_cast<std::uint32_t>(after[task].size()));
    for (const std::uint32_t earlier : after[task])
    {
      before_[earlier].push_back(task);
    }
    if (after[task].empty())
    {
      ready_.push(task);
    }
  }
}

std::uint32_t TaskOrder::begin(double seconds)
{
  std::unique_lock<std::mutex> lock(mutex_);
  if (ready_.empty() && seconds > 0)
  {
    changed_.wait_for(
      lock, std::chrono::duration<double>(seconds), [&] { return !ready_.empty() || left_ == 0; });
  }
  if (ready_.empty() || left_ == 0)
  {
    return None;
  }
  const std::uint32_t task = ready_.top();
  ready_.pop();
  if (--left_ == 0)
  {
    changed_.notify_all();
  }
  return task;
}

void TaskOrder::end(std::uint32_t task)
{
  const std::lock_guard<std::mutex> lock(mutex_);
  ++ended_;
  for (const std::uint32_t later : before_[task])
  {
    if (--waitsFor_[later] == 0)
    {
      ready_.push(later);
      changed_.notify_one();
    }
  }
}

void TaskOrder::cancel()
{
  const std::lock_guard<std::mutex> lock(mutex_);
  left_ = 0;
  changed_.notify_all();
}

}
