// SPDX-License-Identifier: BSD-3-Clause
#include "OpenFoam/LabelRuns.h"

#include <algorithm>

namespace cartesian
{

LabelRuns::LabelRuns(std::vector<std::int32_t> labels)
{
  std::sort(labels.begin(), labels.end());
  std::vector<Run> runs;
  for (const std::int32_t label : labels)
  {
    if (runs.empty() || label > runs.back().end)
    {
      runs.push_back({ label, label + 1, 0 });
    }
    runs.back().end = label + 1;
  }
  unite(runs);
}

void LabelRuns::add(const LabelRuns& others)
{
  std::vector<Run> runs(runs_.size() + others.runs_.size());
  std::merge(runs_.begin(), runs_.end(), others.runs_.begin(), others.runs_.end(), runs.begin(),
    [](const Run& a, const Run& b) { return a.begin < b.begin; });
  unite(runs);
}

// Runs in order of their begins, which may overlap.
void LabelRuns::unite(const std::vector<Run>& runs)
{
  runs_.clear();
  for (const Run& run : runs)
  {
    if (runs_.empty() || run.begin > runs_.back().end)
    {
      runs_.push_back({ run.begin, run.end, size() });
    }
    runs_.back().end = std::max(runs_.back().end, run.end);
  }
}

std::size_t LabelRuns::size() const
{
  return runs_.empty()
    ? 0
    : runs_.back().before + static_cast<std::size_t>(runs_.back().end - runs_.back().begin);
}

std::size_t LabelRuns::countBelow(std::int32_t label) const
{
  const auto next = std::partition_point(
    runs_.begin(), runs_.end(), [label](const Run& run) { return run.begin < label; });
  if (next == runs_.begin())
  {
    return 0;
  }
  const Run& run = *(next - 1);
  return run.before + static_cast<std::size_t>(std::min(label, run.end) - run.begin);
}

void LabelRuns::appendTo(std::vector<double>& numbers) const
{
  numbers.push_back(static_cast<double>(runs_.size()));
  for (const Run& run : runs_)
  {
    numbers.push_back(run.begin);
    numbers.push_back(run.end);
  }
}

LabelRuns LabelRuns::takeFrom(std::vector<double>::const_iterator& next)
{
  std::vector<Run> runs(static_cast<std::size_t>(*next++));
  for (Run& run : runs)
  {
    run.begin = static_cast<std::int32_t>(*next++);
    run.end = static_cast<std::int32_t>(*next++);
  }
  LabelRuns result;
  result.unite(runs);
  return result;
}

}
