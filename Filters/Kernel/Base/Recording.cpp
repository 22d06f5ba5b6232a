// SPDX-License-Identifier: BSD-3-Clause
#include "Base/Recording.h"

#include <algorithm>
#include <ctime>
#include <functional>
#include <istream>
#include <ostream>
#include <sstream>

namespace cartesian
{

namespace
{

constexpr const char* StageWord = "stage";
constexpr const char* SerialWord = "serial";
constexpr const char* LoopWord = "loop";

double processorTime()
{
  timespec time{};
  clock_gettime(CLOCK_THREAD_CPUTIME_ID, &time);
  return static_cast<double>(time.tv_sec) + 1e-9 * static_cast<double>(time.tv_nsec);
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
  steps_.push_back({ stages_.size() - 1, true, {} });
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
  steps_.push_back({ stages_.size() - 1, false, { lap() } });
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
    recording.steps_.push_back({ recording.stages_.size() - 1, word == LoopWord, {} });
    for (double seconds = 0; words >> seconds;)
    {
      recording.steps_.back().tasks.push_back(seconds);
    }
  }
  return recording;
}

double secondsOn(std::size_t threads, const std::vector<double>& tasks)
{
  std::vector<double> free(std::max<std::size_t>(threads, 1)); // a heap, the next to be free first
  for (const double seconds : tasks)
  {
    std::pop_heap(free.begin(), free.end(), std::greater<>());
    free.back() += seconds;
    std::push_heap(free.begin(), free.end(), std::greater<>());
  }
  return *std::max_element(free.begin(), free.end());
}

}
