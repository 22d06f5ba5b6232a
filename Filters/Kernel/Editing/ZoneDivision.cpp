// SPDX-License-Identifier: BSD-3-Clause
#include "Editing/ZoneDivision.h"

#include <algorithm>

namespace cartesian
{

ZoneDivision::ZoneDivision(std::vector<Vector> sample, std::size_t zones)
  : sample_(std::move(sample))
{
  divide(0, sample_.size(), 0, zones);
}

void ZoneDivision::divide(std::size_t begin, std::size_t end, std::size_t first, std::size_t zones)
{
  const std::size_t here = planes_.size();
  planes_.push_back({ first, zones, 0, 0, 0 });
  if (zones < 2)
  {
    return;
  }
  const std::size_t below = zones / 2;
  const std::size_t middle = begin + (end - begin) * below / zones;
  const std::size_t axis = longestAxis(begin, end);
  const auto at = [&](std::size_t i) { return sample_.begin() + static_cast<std::ptrdiff_t>(i); };
  std::nth_element(at(begin), at(middle), at(end),
    [&](const Vector& x, const Vector& y) { return x[axis] < y[axis]; });
  planes_[here].axis = axis;
  planes_[here].at = sample_[middle][axis];
  divide(begin, middle, first, below);
  planes_[here].above = planes_.size();
  divide(middle, end, first + below, zones - below);
}

std::size_t ZoneDivision::longestAxis(std::size_t begin, std::size_t end) const
{
  Vector low = sample_[begin];
  Vector high = low;
  for (std::size_t i = begin; i < end; ++i)
  {
    for (std::size_t axis = 0; axis < 3; ++axis)
    {
      low[axis] = std::min(low[axis], sample_[i][axis]);
      high[axis] = std::max(high[axis], sample_[i][axis]);
    }
  }
  const Vector size = minus(high, low);
  return static_cast<std::size_t>(std::max_element(size.begin(), size.end()) - size.begin());
}

}
