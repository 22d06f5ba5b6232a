// SPDX-License-Identifier: BSD-3-Clause
#include "Base/Recording.h"

#include <algorithm>
#include <array>
#include <cstdio>
#include <cstdlib>
#include <ctime>
#include <functional>
#include <istream>
#include <map>
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

std::vector<std::pair<std::size_t, std::string>> DUMP;
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
  if (std::getenv("STEPDUMP"))
  {
    std::map<std::string, std::array<double, 4>> by;
    std::size_t d = 0;
    std::string name;
    for (std::size_t i = 0; i < steps_.size(); ++i)
    {
      const Step& s = steps_[i];
      double sum = 0;
      for (double t : s.tasks)
        sum += t;
      std::string key = stages_[s.stage] + " | ";
      if (s.isLoop)
        name = DUMP[d++].second;
      else
      {
        name = d < DUMP.size() ? DUMP[d].second : "end";
      }
      auto& v = by[key + (s.isLoop ? "L " : "S before ") + name];
      v[0] += sum;
      v[1] += secondsOn(16, s.tasks) - sum / 16;
      v[2] += 1;
      v[3] += double(s.tasks.size());
    }
    std::vector<std::pair<double, std::string>> order;
    for (auto& [k, v] : by)
      order.push_back({ -v[1], k });
    std::sort(order.begin(), order.end());
    for (auto& [l, k] : order)
    {
      auto& v = by[k];
      if (v[1] > 2e-4)
        std::fprintf(stderr, "%8.4f lost %8.4f s %6.0f steps %6.0f tasks  %s\n", v[1], v[0], v[2],
          v[3], k.c_str());
    }
  }
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
