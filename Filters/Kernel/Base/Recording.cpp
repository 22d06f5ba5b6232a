// SPDX-License-Identifier: BSD-3-Clause
#include "Base/Recording.h"

#include <algorithm>
#include <ctime>
#include <functional>
#include <istream>
#include <ostream>
#include <queue>
#include <sstream>

namespace cartesian
{

namespace
{

constexpr const char* StageWord = "stage";
constexpr const char* SerialWord = "serial";
constexpr const char* LoopWord = "loop";
constexpr const char* AfterWord =
  "after"; // of the loop before it, the next task: what it waits for

double processorTime()
{
  timespec time{};
  clock_gettime(CLOCK_THREAD_CPUTIME_ID, &time);
  return static_cast<double>(time.tv_sec) + 1e-9 * static_cast<double>(time.tv_nsec);
}

void writeOrder(std::ostream& file, const TaskOrder::After& after)
{
  for (const auto& tasks : after)
  {
    file << AfterWord;
    for (const std::uint32_t task : tasks)
    {
      file << ' ' << task;
    }
    file << '\n';
  }
}

}

Recording::Recording()
  : last_(processorTime())
{
}

void Recording::stage(const std::string& name)
{
  endStep();
  stages_.push_back(name);
}

void Recording::beginLoop()
{
  endStep();
  steps_.push_back({ stages_.size() - 1, true, {}, {} });
}

void Recording::beginTasks(const TaskOrder::After& after)
{
  endStep();
  steps_.push_back({ stages_.size() - 1, true, {}, after });
}

void Recording::endTask()
{
  steps_.back().tasks.push_back(lap());
}

void Recording::end()
{
  endStep();
}

double Recording::lap()
{
  const double now = processorTime();
  const double passed = now - last_;
  last_ = now;
  return passed;
}

void Recording::endStep()
{
  steps_.push_back({ stages_.size() - 1, false, { lap() }, {} });
}

void Recording::write(std::ostream& file) const
{
  file.precision(9);
  std::size_t stage = 0;
  for (const Step& step : steps_)
  {
    for (; stage < step.stage; ++stage)
    {
      file << StageWord << ' ' << stages_[stage + 1] << '\n';
    }
    file << (step.isLoop ? LoopWord : SerialWord);
    for (const double seconds : step.tasks)
    {
      file << ' ' << seconds;
    }
    file << '\n';
    writeOrder(file, step.after);
  }
}

Recording Recording::read(std::istream& file)
{
  Recording recording;
  std::string word;
  for (std::string line; std::getline(file, line);)
  {
    std::istringstream words(line);
    words >> word;
    if (word == StageWord)
    {
      recording.stages_.emplace_back();
      std::getline(words >> std::ws, recording.stages_.back());
      continue;
    }
    if (word == AfterWord)
    {
      recording.steps_.back().after.emplace_back();
      for (std::uint32_t task = 0; words >> task;)
      {
        recording.steps_.back().after.back().push_back(task);
      }
      continue;
    }
    recording.steps_.push_back({ recording.stages_.size() - 1, word == LoopWord, {}, {} });
    for (double seconds = 0; words >> seconds;)
    {
      recording.steps_.back().tasks.push_back(seconds);
    }
  }
  return recording;
}

double secondsOn(std::size_t threads, const Recording::Step& step)
{
  TaskOrder order(step.after.empty() ? TaskOrder::After(step.tasks.size()) : step.after);
  using Running = std::pair<double, std::uint32_t>; // when it ends
  std::priority_queue<Running, std::vector<Running>, std::greater<>> running;
  double now = 0;
  for (std::size_t ended = 0; ended < step.tasks.size(); ++ended)
  {
    for (std::uint32_t task = 0; running.size() < std::max<std::size_t>(threads, 1) &&
         (task = order.begin(0)) != TaskOrder::None;)
    {
      running.emplace(now + step.tasks[task], task);
    }
    now = running.top().first;
    order.end(running.top().second);
    running.pop();
  }
  return now;
}

}
