// SPDX-License-Identifier: BSD-3-Clause
#include "Sections/PlaneBuckets.h"

#include <limits>
#include <numeric>

namespace cartesian
{

PlaneBuckets::PlaneBuckets(const std::vector<PlaneRange>& items)
{
  constexpr double Far = std::numeric_limits<double>::max();
  all_ = { { Far, Far }, { -Far, -Far } };
  for (const PlaneRange& item : items)
  {
    for (std::size_t k = 0; k < 2; ++k)
    {
      all_.low[k] = std::min(all_.low[k], item.low[k]);
      all_.high[k] = std::max(all_.high[k], item.high[k]);
    }
  }
  size_ = 1 + static_cast<std::size_t>(std::sqrt(static_cast<double>(items.size())));
  first_.assign(size_ * size_ + 1, 0);
  for (const PlaneRange& item : items)
  {
    forEachCell(item, [&](std::size_t cell) { ++first_[cell + 1]; });
  }
  std::partial_sum(first_.begin(), first_.end(), first_.begin());
  items_.resize(first_.back());
  std::vector<std::size_t> next(first_.begin(), first_.end() - 1);
  for (std::size_t i = 0; i < items.size(); ++i)
  {
    forEachCell(
      items[i], [&](std::size_t cell) { items_[next[cell]++] = static_cast<std::uint32_t>(i); });
  }
}

std::array<std::size_t, 2> PlaneBuckets::cellAt(const PlanePlace& place) const
{
  std::array<std::size_t, 2> cell{};
  for (std::size_t k = 0; k < 2; ++k)
  {
    const double length = all_.high[k] - all_.low[k];
    const double part = length > 0 ? (place[k] - all_.low[k]) / length : 0;
    const auto most = static_cast<double>(size_ - 1);
    cell[k] = static_cast<std::size_t>(std::clamp(part * static_cast<double>(size_), 0.0, most));
  }
  return cell;
}

const std::vector<std::uint32_t>& PlaneBuckets::near(const PlaneRange& range)
{
  found_.clear();
  forEachCell(range, [&](std::size_t cell) {
    found_.insert(found_.end(), items_.begin() + static_cast<std::ptrdiff_t>(first_[cell]),
      items_.begin() + static_cast<std::ptrdiff_t>(first_[cell + 1]));
  });
  std::sort(found_.begin(), found_.end());
  found_.erase(std::unique(found_.begin(), found_.end()), found_.end());
  return found_;
}

}
