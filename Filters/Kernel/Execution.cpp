#include "Execution.h"

#include <algorithm>
#include <atomic>
#include <chrono>
#include <exception>
#include <mutex>
#include <thread>

namespace cartesian
{

namespace
{

// Monitors redraw windows: no more calls than eyes can follow.
constexpr double LeastProgress = 0.005;

double now()
{
  return std::chrono::duration<double>(std::chrono::steady_clock::now().time_since_epoch()).count();
}

}

Execution::Execution(int threads, Monitor monitor)
  : threads_(threads > 0 ? threads : std::max(1, int(std::thread::hardware_concurrency())))
  , monitor_(std::move(monitor))
{
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
  begin_ = begin;
  end_ = end;
  report(0);
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

void Execution::report(double fractionOfStage)
{
  const double fraction = begin_ + fractionOfStage * (end_ - begin_);
  if (!monitor_ || (fraction < reported_ + LeastProgress && fractionOfStage > 0))
  {
    return;
  }
  reported_ = fraction;
  if (!monitor_(fraction, stage_))
  {
    throw Stopped();
  }
}

void Execution::forEach(std::size_t count, std::size_t grain,
  const std::function<void(std::size_t begin, std::size_t end)>& work)
{
  std::atomic<std::size_t> next{ 0 };
  std::atomic<bool> failed{ false };
  std::exception_ptr failure;
  std::mutex mutex;

  const auto loop = [&](bool monitored) {
    try
    {
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
          report(static_cast<double>(begin) / static_cast<double>(count));
        }
      }
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

  const std::size_t most = chunks(count, grain);
  std::vector<std::thread> helpers;
  for (std::size_t i = 1; i < std::min<std::size_t>(threads_, most); ++i)
  {
    helpers.emplace_back(loop, false);
  }
  loop(true);
  for (std::thread& helper : helpers)
  {
    helper.join();
  }
  if (failure)
  {
    std::rethrow_exception(failure);
  }
}

}
