// SPDX-License-Identifier: BSD-3-Clause
#include "Quality/WorstMeasure.h"

#include <algorithm>
#include <utility>

namespace cartesian
{

namespace
{

double valueOf(const std::vector<SummaryValue>& summary, const std::string& name)
{
  const auto found = std::find_if(
    summary.begin(), summary.end(), [&](const SummaryValue& entry) { return entry.name == name; });
  return found == summary.end() ? 0 : found->value;
}

}

double nearnessToLimit(Measure measure, double value, const QualityLimits& limits)
{
  constexpr double LeastLimit = 1e-20; // smaller ones tell signs apart
  const double limit = limits[measure];
  if (limit == NoLimit || limit < LeastLimit)
  {
    return 0;
  }
  return MeasureSpecs[measure].largeIsWorse ? value / limit : limit / std::max(value, Tiny);
}

Measure worstMeasure(const std::vector<SummaryValue>& summary, const QualityLimits& limits)
{
  using Rank = std::pair<double, double>; // failures, nearness
  const auto rankOf = [&](std::size_t m) {
    const MeasureSpec& spec = MeasureSpecs[m];
    const double worst =
      valueOf(summary, std::string(spec.largeIsWorse ? "Max" : "Min") + spec.name);
    return Rank{ valueOf(summary, std::string(spec.name) + "Failures"),
      nearnessToLimit(static_cast<Measure>(m), worst, limits) };
  };
  Measure result = Skewness;
  for (std::size_t m = 0; m < MeasureCount; ++m)
  {
    const bool counts = (FailuresForSolvers >> m & 1U) != 0;
    result = counts && rankOf(m) > rankOf(result) ? static_cast<Measure>(m) : result;
  }
  return result;
}

}
