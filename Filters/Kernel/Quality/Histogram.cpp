// SPDX-License-Identifier: BSD-3-Clause
#include "Quality/Histogram.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>

namespace cartesian
{

namespace
{

ValueRange withExtent(ValueRange range)
{
  if (!(range.low <= range.high))
  {
    return { 0, 1 };
  }
  const double least = std::max(1e-9 * std::abs(range.low), std::numeric_limits<double>::min());
  return range.high - range.low > least
    ? range
    : ValueRange{ range.low, range.low + std::max(std::abs(range.low), 1.0) };
}

}

ValueRange rangeOf(const std::vector<double>& values)
{
  constexpr double Infinity = std::numeric_limits<double>::infinity();
  ValueRange range{ Infinity, -Infinity };
  for (const double value : values)
  {
    if (std::isfinite(value))
    {
      range = { std::min(range.low, value), std::max(range.high, value) };
    }
  }
  return range;
}

std::size_t Histogram::total() const
{
  return std::accumulate(counts.begin(), counts.end(), std::size_t(0));
}

double Histogram::edge(std::size_t bin) const
{
  const double part = static_cast<double>(bin) / static_cast<double>(counts.size());
  return range.low + part * (range.high - range.low);
}

Histogram histogramOf(const std::vector<double>& values, ValueRange range, std::size_t bins)
{
  Histogram histogram{ withExtent(range), std::vector<std::size_t>(bins) };
  const double last = static_cast<double>(bins) - 1;
  const double scale = static_cast<double>(bins) / (histogram.range.high - histogram.range.low);
  for (const double value : values)
  {
    if (!std::isnan(value))
    {
      const double bin = std::floor((value - histogram.range.low) * scale);
      ++histogram.counts[static_cast<std::size_t>(std::clamp(bin, 0.0, last))];
    }
  }
  return histogram;
}

}
