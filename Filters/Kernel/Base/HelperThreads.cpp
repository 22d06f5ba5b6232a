// SPDX-License-Identifier: BSD-3-Clause
#include "Base/HelperThreads.h"

#include <algorithm>
#include <chrono>
#include <new>
#include <system_error>

namespace cartesian
{

HelperThreads::~HelperThreads()
{
  {
    const std::lock_guard<std::mutex> lock(mutex_);
    quits_ = true;
  }
  begun_.notify_all();
  for (std::thread& thread : threads_)
  {
    thread.join();
  }
}

void HelperThreads::begin(std::size_t most, const std::function<void()>& work)
{
  start(most);
  const std::size_t wanted = std::min(most, threads_.size());
  {
    const std::lock_guard<std::mutex> lock(mutex_);
    work_ = &work;
    wanted_ = wanted;
  }
  for (std::size_t i = 0; i < wanted; ++i)
  {
    begun_.notify_one();
  }
}

bool HelperThreads::haveEnded(double seconds)
{
  std::unique_lock<std::mutex> lock(mutex_);
  wanted_ = 0;
  return ended_.wait_for(
    lock, std::chrono::duration<double>(seconds), [&] { return running_ == 0; });
}

void HelperThreads::start(std::size_t most)
{
  try
  {
    while (threads_.size() < most)
    {
      threads_.emplace_back([this] { help(); });
    }
  }
  catch (const std::system_error&) // too many threads, or no memory for a stack
  {
  }
  catch (const std::bad_alloc&)
  {
  }
}

void HelperThreads::help()
{
  std::unique_lock<std::mutex> lock(mutex_);
  while (true)
  {
    begun_.wait(lock, [&] { return wanted_ > 0 || quits_; });
    if (quits_)
    {
      return;
    }
    --wanted_;
    ++running_;
    const std::function<void()>& work = *work_;
    lock.unlock();
    work();
    lock.lock();
    if (--running_ == 0)
    {
      ended_.notify_one();
    }
  }
}

}
