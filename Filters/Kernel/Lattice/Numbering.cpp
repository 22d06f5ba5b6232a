// SPDX-License-Identifier: BSD-3-Clause
#include "Lattice/Numbering.h"

namespace cartesian
{

namespace
{

constexpr std::size_t RowsAChunk = 4;

template <class Visitor>
void forEachDistinct(const PointUse* begin, const PointUse* end, Visitor&& visit)
{
  while (begin != end)
  {
    const PointUse* next = begin + 1;
    while (next != end && areSame(next->point, begin->point))
    {
      ++next;
    }
    visit(begin, next);
    begin = next;
  }
}

}

void offsetSlots(std::vector<std::vector<PointUse>>& uses)
{
  std::size_t before = 0;
  for (auto& chunk : uses)
  {
    for (PointUse& use : chunk)
    {
      use.slot += static_cast<std::uint32_t>(before);
    }
    before += chunk.size();
  }
}

Numbering numberPoints(
  std::vector<std::vector<PointUse>>& uses, std::size_t rows, Execution& execution)
{
  const Buckets<PointUse> byRow = sortIntoBuckets(
    uses, rows, [](const PointUse& u) { return u.row; }, execution);
  Numbering result;
  result.rowStart.assign(rows + 1, 0);
  execution.forEach(rows, RowsAChunk, [&](std::size_t begin, std::size_t end) {
    for (std::size_t row = begin; row < end; ++row)
    {
      forEachDistinct(byRow.begin(row), byRow.end(row),
        [&](const PointUse*, const PointUse*) { ++result.rowStart[row]; });
    }
  });
  result.points.resize(scan(result.rowStart));
  result.ofSlot.resize(byRow.items.size());
  execution.forEach(rows, RowsAChunk, [&](std::size_t begin, std::size_t end) {
    for (std::size_t row = begin; row < end; ++row)
    {
      auto id = static_cast<std::uint32_t>(result.rowStart[row]);
      forEachDistinct(
        byRow.begin(row), byRow.end(row), [&](const PointUse* first, const PointUse* last) {
          result.points[id] = first->point;
          for (const PointUse* use = first; use != last; ++use)
          {
            result.ofSlot[use->slot] = id;
          }
          ++id;
        });
    }
  });
  return result;
}

void LocalPoints::clear()
{
  points_.clear();
  ++epoch_;
  if (table_.empty())
  {
    grow();
  }
}

std::uint32_t LocalPoints::add(const Point& point)
{
  std::size_t slot = slotOf(point);
  if (epochs_[slot] != epoch_)
  {
    points_.push_back(point);
    table_[slot] = static_cast<std::uint32_t>(points_.size() - 1);
    epochs_[slot] = epoch_;
    if (2 * points_.size() > table_.size())
    {
      grow();
      return static_cast<std::uint32_t>(points_.size() - 1);
    }
  }
  return table_[slot];
}

std::size_t LocalPoints::slotOf(const Point& point) const
{
  std::uint64_t hash = point[0] * 0x9E3779B97F4A7C15u;
  hash = (hash ^ (hash >> 29) ^ point[1]) * 0xBF58476D1CE4E5B9u;
  hash = (hash ^ (hash >> 32) ^ point[2]) * 0x94D049BB133111EBu;
  const std::size_t mask = table_.size() - 1;
  std::size_t slot = (hash >> 32) & mask;
  while (epochs_[slot] == epoch_ && !areSame(points_[table_[slot]], point))
  {
    slot = (slot + 1) & mask;
  }
  return slot;
}

void LocalPoints::grow()
{
  constexpr std::size_t LeastSlots = 256;
  const std::size_t slots = std::max(LeastSlots, 2 * table_.size());
  table_.assign(slots, 0);
  epochs_.assign(slots, 0);
  epoch_ = 1;
  for (std::uint32_t i = 0; i < points_.size(); ++i)
  {
    const std::size_t slot = slotOf(points_[i]);
    table_[slot] = i;
    epochs_[slot] = epoch_;
  }
}

}
