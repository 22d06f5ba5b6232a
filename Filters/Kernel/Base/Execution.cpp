// SPDX-License-Identifier: BSD-3-Clause
#include "Base/Execution.h"

#include <algorithm>
#include <chrono>
#include <exception>
#include <new>
#include <numeric>
#include <system_error>

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

// Threads that run beside the caller's, as many of `most` as the system can start: work that is cut
// into chunks gets done by fewer.
template <class Work>
std::vector<std::thread> startThreads(std::size_t most, const Work& work)
{
  std::vector<std::thread> threads;
  threads.reserve(most);
  try
  {
    while (threads.size() < most)
    {
      threads.emplace_back(work);
    }
  }
  catch (const std::system_error&) // too many threads, or no memory for a stack
  {
  }
  catch (const std::bad_alloc&)
  {
  }
  return threads;
}

}

Execution::Execution(int threads, Monitor monitor, double begin, double end)
  : threads_(threads > 0 ? threads : std::max(1, int(std::thread::hardware_concurrency())))
  , monitor_(std::move(monitor))
  , work_{ begin, end }
{
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
void Execution::waitFor(
  std::mutex& mutex, std::condition_variable& ended, const std::size_t& running)
{
  std::unique_lock<std::mutex> lock(mutex);
  while (!ended.wait_for(
    lock, std::chrono::duration<double>(LongestSilence), [&] { return running == 0; }))
  {
    lock.unlock();
    if (!isHelper())
    {
      askIfTime(true);
    }
    lock.lock();
  }
}

void Execution::forEach(std::size_t count, std::size_t grain,
  const std::function<void(std::size_t begin, std::size_t end)>& work)
{
  std::atomic<std::size_t> next{ 0 };
  std::atomic<bool> failed{ false };
  std::exception_ptr failure;
  std::mutex mutex;
  std::condition_variable ended;
  std::size_t running = 0; // helpers

  const auto attempt = [&](auto&& part) {
    try
    {
      part();
    }
    catch (...)
    {
      const std::lock_guard<std::mutex> lock(mutex);
      if (!failed.exchange(true))
      {
        failure = std::current_exception();
      }
    }
  };
  const auto loop = [&](bool monitored) {
    while (!failed)
    {
      const std::size_t begin = next.fetch_add(grain);
      if (begin >= count)
      {
        return;
      }
      work(begin, std::min(begin + grain, count));
      if (monitored)
      {
        advance(static_cast<double>(begin) / static_cast<double>(count));
        poll();
      }
    }
  };

  loop_ = { loop_.end, loop_.end + share_ * (stageEnd_ - loop_.end) };
  share_ = 0;
  const std::size_t most = std::min<std::size_t>(threads_, chunks(count, grain));
  running = most > 0 ? most - 1 : 0;
  std::vector<std::thread> helpers = startThreads(running, [&] {
    attempt([&] { loop(false); });
    const std::lock_guard<std::mutex> lock(mutex);
    --running;
    ended.notify_one();
  });
  {
    const std::lock_guard<std::mutex> lock(mutex);
    running -= most > 0 ? most - 1 - helpers.size() : 0; // those that could not be started
  }
  attempt([&] { loop(true); });
  attempt([&] { waitFor(mutex, ended, running); });
  for (std::thread& helper : helpers)
  {
    helper.join();
  }
  if (failure)
  {
    std::rethrow_exception(failure);
  }
  advance(1);
  poll();
}

}
