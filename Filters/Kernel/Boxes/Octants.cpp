// SPDX-License-Identifier: BSD-3-Clause
#include "Boxes/Octants.h"

#include <numeric>

namespace cartesian
{

namespace
{

constexpr unsigned BitsOfLevel = 4;
constexpr std::uint64_t LevelMask = (1U << BitsOfLevel) - 1;

int levelOf(const Octants::Key& key)
{
  return static_cast<int>(key.second & LevelMask);
}

// The bits of a coordinate, three apart.
std::uint64_t spread(std::uint64_t bits)
{
  bits = (bits | bits << 16) & 0x1f'0000'ff00'00ffULL;
  bits = (bits | bits << 8) & 0x100f'00f0'0f00'f00fULL;
  bits = (bits | bits << 4) & 0x10c3'0c30'c30c'30c3ULL;
  return (bits | bits << 2) & 0x1249'2492'4924'9249ULL;
}

std::uint64_t codeOf(const Offset& offset, int level)
{
  const std::uint64_t place = spread(offset[0]) | spread(offset[1]) << 1 | spread(offset[2]) << 2;
  return place << BitsOfLevel | static_cast<std::uint64_t>(level);
}

// The number of places in an octant, by its level.
std::uint64_t placesIn(int level)
{
  return std::uint64_t(1) << (3 * (DeepestLevel - level));
}

// The bits of every third place.
std::uint32_t gathered(std::uint64_t place)
{
  std::uint32_t bits = 0;
  for (unsigned i = 0; i < DeepestLevel; ++i)
  {
    bits |= static_cast<std::uint32_t>(place >> 3 * i & 1) << i;
  }
  return bits;
}

// The octant of the next coarser level that holds this one.
Octants::Key around(const Octants::Key& key)
{
  const int level = levelOf(key) - 1;
  const std::uint64_t place = (key.second >> BitsOfLevel) & ~(placesIn(level) - 1);
  return { key.first, place << BitsOfLevel | static_cast<std::uint64_t>(level) };
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

std::uint64_t Octants::numberOf(const std::array<std::uint32_t, 3>& global) const
{
  return global[0] + across_[0] * (global[1] + across_[1] * global[2]);
}

Octants::Key Octants::keyOf(const Octant& octant) const
{
  Offset offset;
  for (std::size_t axis = 0; axis < 3; ++axis)
  {
    offset[axis] =
      static_cast<std::uint16_t>(octant.position[axis] << (DeepestLevel - octant.level));
  }
  return { numberOf(octant.global), codeOf(offset, octant.level) };
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

int Octants::deepest() const
{
  return deepestIn({ keys_.begin(), keys_.end() });
}

int Octants::deepestIn(const Range& range)
{
  return std::accumulate(range.first, range.second, 0,
    [](int deepest, const Key& key) { return std::max(deepest, levelOf(key)); });
}

std::size_t Octants::countBelow(const Range& range, int level)
{
  return static_cast<std::size_t>(
    std::count_if(range.first, range.second, [&](const Key& key) { return levelOf(key) > level; }));
}

Octants::Range Octants::in(const std::array<std::uint32_t, 3>& global) const
{
  const Key first{ numberOf(global), 0 };
  const auto begin = std::lower_bound(keys_.begin(), keys_.end(), first);
  return { begin, std::lower_bound(begin, keys_.end(), Key{ first.first + 1, 0 }) };
}

Octants::Range Octants::in(const Range& ofGlobal, const Cube& cube)
{
  if (ofGlobal.first == ofGlobal.second)
  {
    return ofGlobal;
  }
  const std::uint64_t global = ofGlobal.first->first;
  const std::uint64_t code = codeOf(cube.offset, cube.level);
  const std::uint64_t end = code + (placesIn(cube.level) << BitsOfLevel);
  const auto begin = std::lower_bound(ofGlobal.first, ofGlobal.second, Key{ global, code + 1 });
  return { begin, std::lower_bound(begin, ofGlobal.second, Key{ global, end & ~LevelMask }) };
}

void Octants::raise(
  const Range& range, const Cube& cube, int bits, std::vector<std::uint8_t>& forced)
{
  for (auto key = range.first; key != range.second; ++key)
  {
    const int level = levelOf(*key);
    const std::uint64_t place = key->second >> BitsOfLevel;
    const int shift = DeepestLevel - cube.level - bits;
    const std::size_t size = std::size_t(1) << std::max(0, cube.level + bits - level);
    std::array<std::size_t, 3> low;
    for (unsigned axis = 0; axis < 3; ++axis)
    {
      low[axis] = (gathered(place >> axis) - cube.offset[axis]) >> shift;
    }
    for (std::size_t z = low[2]; z < low[2] + size; ++z)
    {
      for (std::size_t y = low[1]; y < low[1] + size; ++y)
      {
        const auto row =
          forced.begin() + static_cast<std::ptrdiff_t>(low[0] + (y << bits) + (z << 2 * bits));
        std::transform(row, row + static_cast<std::ptrdiff_t>(size), row,
          [&](std::uint8_t depth) { return std::max(depth, static_cast<std::uint8_t>(level)); });
      }
    }
  }
}

}
