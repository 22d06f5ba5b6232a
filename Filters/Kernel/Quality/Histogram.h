// SPDX-License-Identifier: BSD-3-Clause
// How often values occur, in bins of equal width.
#pragma once

#include <cstddef>
#include <vector>

namespace cartesian
{

struct ValueRange
{
  double low;
  double high; // below `low`: there are no values
};

// Of the finite values.
ValueRange rangeOf(const std::vector<double>& values);

struct Histogram
{
  ValueRange range; // of the bins; `low` < `high`
  std::vector<std::size_t> counts;

  std::size_t total() const;
  // The lower end of a bin, or the upper end of the last.
  double edge(std::size_t bin) const;
};

// Counts every value that is a number: what lies beyond the range is in the first or the last bin. A range without an
// extent gets one; `bins`: 1 or more.
Histogram histogramOf(const std::vector<double>& values, ValueRange range, std::size_t bins);

}
