// SPDX-License-Identifier: BSD-3-Clause
#include "Boxes/Octants.h"

namespace cartesian
{

namespace
{

// Of one coordinate of a position; the level is above the three.
constexpr unsigned Bits = DeepestSearched;
constexpr std::uint32_t Mask = (1U << Bits) - 1;

int levelOf(const Octants::Key& key)
{
  return static_cast<int>(key.second >> 3 * Bits);
}

// The octant of the next coarser level that holds this one.
Octants::Key around(const Octants::Key& key)
{
  const auto half = [&](unsigned axis) {
    return (key.second >> axis * Bits & Mask) / 2 << axis * Bits;
  };
  const auto level = static_cast<std::uint32_t>(levelOf(key) - 1);
  return { key.first, level << 3 * Bits | half(2) | half(1) | half(0) };
}

Point cornerOf(const Octant& octant, const Meshlines& planes, std::int64_t beyond)
{
  Point corner;
  for (std::size_t axis = 0; axis < 3; ++axis)
  {
    const std::int64_t part = octant.position[axis] + beyond;
    corner[axis] = planeAt(planes, axis, octant.global[axis], part * (FinePerBox >> octant.level));
  }
  return corner;
}

}

Octant Octant::part(unsigned which) const
{
  Octant result{ global, level + 1, {} };
  for (unsigned axis = 0; axis < 3; ++axis)
  {
    result.position[axis] = 2 * position[axis] + (which >> axis & 1);
  }
  return result;
}

Point lowOf(const Octant& octant, const Meshlines& planes)
{
  return cornerOf(octant, planes, 0);
}

Point highOf(const Octant& octant, const Meshlines& planes)
{
  return cornerOf(octant, planes, 1);
}

Octants::Key Octants::keyOf(const Octant& octant) const
{
  const auto& [i, j, k] = octant.global;
  const auto& [x, y, z] = octant.position;
  return { i + across_[0] * (j + across_[1] * k),
    static_cast<std::uint32_t>(octant.level) << 3 * Bits | z << 2 * Bits | y << Bits | x };
}

void Octants::add(std::vector<std::vector<Key>>& lists)
{
  for (std::vector<Key>& list : lists)
  {
    keys_.insert(keys_.end(), list.begin(), list.end());
    list = {};
  }
  leaveOutTwins();
  const std::size_t given = keys_.size();
  for (std::size_t i = 0; i < given; ++i)
  {
    for (Key key = around(keys_[i]); levelOf(key) > 0; key = around(key))
    {
      keys_.push_back(key);
    }
  }
  leaveOutTwins();
}

void Octants::leaveOutTwins()
{
  std::sort(keys_.begin(), keys_.end());
  keys_.erase(std::unique(keys_.begin(), keys_.end()), keys_.end());
}

Octants::Range Octants::rangeOf(const std::array<std::uint32_t, 3>& global) const
{
  const Key first{ keyOf({ global }).first, 0 };
  const Key end{ first.first + 1, 0 };
  const auto begin = std::lower_bound(keys_.begin(), keys_.end(), first);
  return { begin, std::lower_bound(begin, keys_.end(), end) };
}

int Octants::deepest() const
{
  int deepest = 0;
  for (const Key& key : keys_)
  {
    deepest = std::max(deepest, levelOf(key));
  }
  return deepest;
}

int Octants::deepestIn(const std::array<std::uint32_t, 3>& global) const
{
  const Range range = rangeOf(global);
  return range.first == range.second ? 0 : levelOf(*(range.second - 1));
}

std::size_t Octants::countIn(const std::array<std::uint32_t, 3>& global) const
{
  const Range range = rangeOf(global);
  return static_cast<std::size_t>(range.second - range.first);
}

void Octants::raise(const std::array<std::uint32_t, 3>& global, int unitDepth,
  std::vector<std::uint8_t>& forced) const
{
  const Range range = rangeOf(global);
  for (auto key = range.first; key != range.second; ++key)
  {
    const std::uint32_t part = key->second;
    const auto level = static_cast<std::uint8_t>(levelOf(*key));
    const int shift = unitDepth - level;
    const std::size_t size = std::size_t(1) << shift;
    const std::size_t x0 = std::size_t(part & Mask) << shift;
    const std::size_t y0 = std::size_t(part >> Bits & Mask) << shift;
    const std::size_t z0 = std::size_t(part >> 2 * Bits & Mask) << shift;
    for (std::size_t z = z0; z < z0 + size; ++z)
    {
      for (std::size_t y = y0; y < y0 + size; ++y)
      {
        const auto row = forced.begin() +
          static_cast<std::ptrdiff_t>(x0 + (y << unitDepth) + (z << 2 * unitDepth));
        std::transform(row, row + static_cast<std::ptrdiff_t>(size), row,
          [&](std::uint8_t depth) { return std::max(depth, level); });
      }
    }
  }
}

}
