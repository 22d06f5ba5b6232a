// SPDX-License-Identifier: BSD-3-Clause
// Runs loops on several threads, reports progress, and lets the user stop the work.
//
// Work is divided into chunks of a fixed number of items, so that the results never depend on the
// number of threads. Only the calling thread reports progress and asks whether to continue.
#pragma once

#include "Base/HelperThreads.h"

#include <atomic>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <stdexcept>
#include <string>
#include <thread>
#include <utility>
#include <vector>

namespace cartesian
{

class Recording;

// Thrown from a stage that the user stopped.
struct Stopped : std::runtime_error
{
  Stopped()
    : std::runtime_error("stopped by the user")
  {
  }
};

class Execution
{
public:
  // Called many times a second with the fraction of the work done (0 to 1, never falling) and the
  // stage's name; returns false to stop.
  using Monitor = std::function<bool(double fraction, const char* stage)>;

  static constexpr int AllCores = 0;

  // `threads` AllCores: one per core. Stages are given as parts of a whole (0 to 1); the work is the part
  // of this whole from `begin` to `end`.
  explicit Execution(int threads = 1, Monitor monitor = nullptr, double begin = 0, double end = 1);

  int threads() const { return threads_; }

  // From now on all work is done on one thread, and recorded.
  void record(Recording& recording);

  // Declares that the part of the whole from `begin` to `end` takes no time: parts that do not overlap.
  void leaveOut(double begin, double end);

  // Begins the stage `name`, from `begin` to `end` of the whole.
  void stage(const char* name, double begin, double end);

  // The next forEach takes this share (0 to 1) of the rest of the stage. If not called, the loop
  // reports no progress.
  void nextLoop(double share) { share_ = share; }

  // To be called in long loops other than forEach: reports progress when it is time to, and throws
  // Stopped if the user wants to stop. On a helper thread of forEach it only throws, once the
  // calling thread has noticed.
  void poll();

  // The stage is done so far (0 to 1): for long loops other than forEach.
  void reach(double fraction);

  // For work inside a forEach, which is its part from `begin` to `end` (0 to 1): runs on one thread and polls
  // this object.
  Execution alone(double begin, double end);

  // Seconds spent in each stage so far, in the order in which stages began.
  std::vector<std::pair<std::string, double>> seconds() const;

  // Calls work(begin, end) for chunks of `grain` items of [0, count), on all threads, or on as many as
  // the system can start. An exception ends the loop and is rethrown here. Chunks that may take longer than a
  // tenth of a second poll.
  void forEach(std::size_t count, std::size_t grain,
    const std::function<void(std::size_t begin, std::size_t end)>& work);

  // Calls work(task) for the tasks 0, 1, ... on all threads, each as soon as those in `after` of it have ended, without
  // waiting for others. `after`: of each task, lower numbers, ascending. Ready tasks begin in order. An exception ends it
  // as in forEach; tasks that may take longer than a tenth of a second poll.
  void forEachInOrder(const std::vector<std::vector<std::uint32_t>>& after,
    const std::function<void(std::uint32_t task)>& work);

private:
  struct WorkRange
  {
    double begin;
    double end;
  };

  double workUpTo(double whole) const;
  bool isHelper() const;
  void askIfTime(bool readsClock);
  void advance(double fractionOfLoop);
  void ask();
  void waitForHelpers();
  void run(std::size_t count, std::size_t grain,
    const std::function<void(std::size_t begin, std::size_t end)>& work);
  void runOnThreads(std::size_t most, const std::function<void(bool monitored)>& loop,
    const std::function<void()>& cancel);

  int threads_;
  HelperThreads helpers_;
  Recording* recording_ = nullptr;
  std::thread::id owner_ = std::this_thread::get_id();
  std::atomic<bool> stopped_{ false };
  Monitor monitor_;
  WorkRange work_;                 // of the whole
  std::vector<WorkRange> leftOut_; // of the whole
  const char* stage_ = "";
  WorkRange loop_{ 0, 1 }; // of the whole
  double stageEnd_ = 1;    // of the whole
  double share_ = 0;       // of the next loop
  double reported_ = 0;    // of the work
  double asked_ = 0;       // when the monitor was last called, and what was reported then
  double reportedThen_ = 0;
  unsigned polls_ = 0;
  double started_ = 0;
  std::vector<std::pair<std::string, double>> seconds_;
};

// The number of chunks that forEach makes, for loops in which each chunk has its own result.
inline std::size_t chunks(std::size_t count, std::size_t grain)
{
  return (count + grain - 1) / grain;
}

}
