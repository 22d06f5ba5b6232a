// SPDX-License-Identifier: BSD-3-Clause
// Threads that wait for work beside their owner's, from loop to loop: to start them anew takes longer than many loops.
#pragma once

#include <condition_variable>
#include <cstddef>
#include <functional>
#include <mutex>
#include <thread>
#include <vector>

namespace cartesian
{

class HelperThreads
{
public:
  HelperThreads() = default;
  HelperThreads(const HelperThreads&) = delete;
  HelperThreads& operator=(const HelperThreads&) = delete;
  ~HelperThreads();

  // Lets up to `most` helpers call `work`, or as many as the system can start. It must not throw, and live until they
  // have ended.
  void begin(std::size_t most, const std::function<void()>& work);

  // From now on none begins; waits up to `seconds` for those that have. Returns whether all have ended.
  bool haveEnded(double seconds);

private:
  void start(std::size_t most);
  void help();

  std::mutex mutex_; // of all below, except the threads
  std::condition_variable begun_;
  std::condition_variable ended_;
  const std::function<void()>* work_ = nullptr;
  std::size_t wanted_ = 0;
  std::size_t running_ = 0;
  bool quits_ = false;
  std::vector<std::thread> threads_;
};

}
