// SPDX-License-Identifier: BSD-3-Clause
#include "Base/Execution.h"

#include "Base/Recording.h"
#include "Base/TaskOrder.h"

#include <algorithm>
#include <chrono>
#include <exception>
#include <mutex>
#include <numeric>

namespace cartesian
{

namespace
{

// The monitor is called after this much progress or this many seconds: often enough to stop at
// once, but no more often than the eye can follow.
constexpr double LeastProgress = 0.005;
constexpr double LongestSilence = 0.05;

constexpr unsigned PollsPerClockReading = 8;

double now()
{
  return std::chrono::duration<double>(std::chrono::steady_clock::now().time_since_epoch()).count();
}

}

Execution::Execution(int threads, Monitor monitor, double begin, double end)
  : threads_(threads > 0 ? threads : std::max(1, int(std::thread::hardware_concurrency())))
  , monitor_(std::move(monitor))
  , work_{ begin, end }
{
}

void Execution::record(Recording& recording)
{
  recording_ = &recording;
  threads_ = 1;
}

void Execution::leaveOut(double begin, double end)
{
  leftOut_.push_back({ begin, end });
}

// How much of the whole, up to this point, is not left out.
double Execution::workUpTo(double whole) const
{
  return std::accumulate(
    leftOut_.begin(), leftOut_.end(), whole, [&](double work, const WorkRange& part) {
      return work - (std::min(whole, part.end) - std::min(whole, part.begin));
    });
}

void Execution::stage(const char* name, double begin, double end)
{
  const double time = now();
  if (!seconds_.empty())
  {
    seconds_.back().second = time - started_;
  }
  seconds_.emplace_back(name, 0.0);
  started_ = time;
  stage_ = name;
  if (recording_)
  {
    recording_->stage(name);
  }
  loop_ = { begin, begin };
  stageEnd_ = end;
  share_ = 0;
  advance(0);
  ask();
}

std::vector<std::pair<std::string, double>> Execution::seconds() const
{
  auto all = seconds_;
  if (!all.empty())
  {
    all.back().second = now() - started_;
  }
  return all;
}

void Execution::advance(double fractionOfLoop)
{
  const double whole = loop_.begin + fractionOfLoop * (loop_.end - loop_.begin);
  const double before = workUpTo(work_.begin);
  const double fraction = (workUpTo(whole) - before) / (workUpTo(work_.end) - before);
  reported_ = std::max(reported_, std::min(fraction, 1.0));
}

// Single-threaded work has read the clock before: counting its calls again would make gaps eight times as long.
Execution Execution::alone(double begin, double end)
{
  return Execution(1, [this, begin, end](double fraction, const char*) {
    if (!isHelper())
    {
      advance(begin + fraction * (end - begin));
      askIfTime(true);
    }
    return true;
  });
}

void Execution::reach(double fraction)
{
  loop_.end = stageEnd_;
  advance(fraction);
  poll();
}

void Execution::poll()
{
  if (!isHelper())
  {
    askIfTime(++polls_ % PollsPerClockReading == 0);
  }
}

// Whether this thread helps the calling one; throws where that has noticed that the user wants to stop.
bool Execution::isHelper() const
{
  const bool helper = std::this_thread::get_id() != owner_;
  if (helper && stopped_)
  {
    throw Stopped();
  }
  return helper;
}

void Execution::askIfTime(bool readsClock)
{
  if (monitor_ &&
    (reported_ >= reportedThen_ + LeastProgress || (readsClock && now() > asked_ + LongestSilence)))
  {
    ask();
  }
}

void Execution::ask()
{
  if (monitor_ && !monitor_(reported_, stage_))
  {
    stopped_ = true;
    throw Stopped();
  }
  asked_ = now();
  reportedThen_ = reported_;
}

// Polls while other threads have chunks of their own to finish, however long they take.
void Execution::waitForHelpers()
{
  while (!helpers_.haveEnded(LongestSilence))
  {
    if (!isHelper())
    {
      askIfTime(true);
    }
  }
}

void Execution::forEach(std::size_t count, std::size_t grain,
  const std::function<void(std::size_t begin, std::size_t end)>& work)
{
  if (!recording_)
  {
    run(count, grain, work);
    return;
  }
  recording_->beginLoop();
  run(count, grain, [&](std::size_t begin, std::size_t end) {
    work(begin, end);
    recording_->endTask();
  });
}

void Execution::forEachInOrder(const std::vector<std::vector<std::uint32_t>>& after,
  const std::function<void(std::uint32_t task)>& work)
{
  if (recording_)
  {
    recording_->beginTasks(after);
  }
  TaskOrder order(after);
  const auto loop = [&](bool monitored) {
    while (!order.haveAllBegun())
    {
      if (const std::uint32_t task = order.begin(LongestSilence); task != TaskOrder::None)
      {
        work(task);
        order.end(task);
        recording_ ? recording_->endTask() : void();
      }
      if (monitored)
      {
        advance(static_cast<double>(order.ended()) / static_cast<double>(after.size()));
        askIfTime(true);
      }
    }
  };
  runOnThreads(std::min<std::size_t>(threads_, after.size()), loop, [&] { order.cancel(); });
}

void Execution::run(std::size_t count, std::size_t grain,
  const std::function<void(std::size_t begin, std::size_t end)>& work)
{
  std::atomic<std::size_t> next{ 0 };
  const auto loop = [&](bool monitored) {
    for (std::size_t begin = next.fetch_add(grain); begin < count; begin = next.fetch_add(grain))
    {
      work(begin, std::min(begin + grain, count));
      if (monitored)
      {
        advance(static_cast<double>(begin) / static_cast<double>(count));
        poll();
      }
    }
  };
  runOnThreads(std::min<std::size_t>(threads_, chunks(count, grain)), loop, [&] { next = count; });
}

// `loop` returns once nothing is left to begin, which `cancel` makes so.
void Execution::runOnThreads(std::size_t most, const std::function<void(bool monitored)>& loop,
  const std::function<void()>& cancel)
{
  std::exception_ptr failure;
  std::mutex mutex;
  const auto attempt = [&](auto&& part) {
    try
    {
      part();
    }
    catch (...)
    {
      const std::lock_guard<std::mutex> lock(mutex);
      if (!failure)
      {
        failure = std::current_exception();
      }
      cancel();
    }
  };
  loop_ = { loop_.end, loop_.end + share_ * (stageEnd_ - loop_.end) };
  share_ = 0;
  const std::function<void()> help = [&] { attempt([&] { loop(false); }); };
  if (most > 1)
  {
    helpers_.begin(most - 1, help);
  }
  attempt([&] { loop(true); });
  attempt([&] { waitForHelpers(); });
  while (!helpers_.haveEnded(LongestSilence)) // once stopped
  {
  }
  if (failure)
  {
    std::rethrow_exception(failure);
  }
  advance(1);
  poll();
}

}
