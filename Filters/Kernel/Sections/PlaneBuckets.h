// SPDX-License-Identifier: BSD-3-Clause
// A grid over a part of a plane, to find what is near a place.
#pragma once

#include "Sections/PlanePolygons.h"

#include <algorithm>

namespace cartesian
{

// Of points: low and high are the same.
struct PlaneRange
{
  PlanePlace low;
  PlanePlace high;

  void grow(double by)
  {
    for (std::size_t k = 0; k < 2; ++k)
    {
      low[k] -= by;
      high[k] += by;
    }
  }
};

inline PlaneRange rangeOf(const PlanePlace& a, const PlanePlace& b)
{
  return { { std::min(a[0], b[0]), std::min(a[1], b[1]) },
    { std::max(a[0], b[0]), std::max(a[1], b[1]) } };
}

class PlaneBuckets
{
public:
  // Of items 0, 1, 2, ...
  explicit PlaneBuckets(const std::vector<PlaneRange>& items);

  // Those that may touch a range, in order.
  const std::vector<std::uint32_t>& near(const PlaneRange& range);

private:
  std::array<std::size_t, 2> cellAt(const PlanePlace& place) const;

  template <class Visitor>
  void forEachCell(const PlaneRange& range, Visitor&& visit) const
  {
    const auto first = cellAt(range.low);
    const auto last = cellAt(range.high);
    for (std::size_t j = first[1]; j <= last[1]; ++j)
    {
      for (std::size_t i = first[0]; i <= last[0]; ++i)
      {
        visit(j * size_ + i);
      }
    }
  }

  PlaneRange all_;
  std::size_t size_ = 1;           // cells along either side
  std::vector<std::size_t> first_; // of each cell, and the end
  std::vector<std::uint32_t> items_;
  std::vector<std::uint32_t> found_;
};

}
