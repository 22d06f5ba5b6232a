// SPDX-License-Identifier: BSD-3-Clause
// Places within a global box.
#pragma once

#include <algorithm>
#include <array>
#include <cstdint>

namespace cartesian
{

constexpr std::uint32_t None = ~std::uint32_t(0);

// The most halvings in one direction. They define the fine grid: positions count the smallest
// possible parts of global boxes, from the first meshline on.
constexpr int DeepestLevel = 12;
constexpr std::int64_t FinePerBox = 1 << DeepestLevel;
using FinePoint = std::array<std::int64_t, 3>;

enum class BoxStatus : std::uint8_t
{
  Outside = 0, // never kept
  Inside = 1,
  Intersected = 2, // a triangle passes through it
};

// Of a box's corners: all are inside.
constexpr std::uint8_t AllCorners = 0xff;

// Of the low corner in its global box, fine.
using Offset = std::array<std::uint16_t, 3>;

struct LocalBox
{
  Offset offset;
  std::array<std::uint8_t, 3> level; // halvings along x, y, z
  BoxStatus status;
  std::uint8_t corners; // as in PackedBox
};

// A global box, or a part of it that is halved as often along each axis.
struct Cube
{
  Offset offset{};
  int level = 0;

  std::int64_t size() const { return FinePerBox >> level; }

  // Of the units that halving it so often makes: x fastest.
  Cube part(int bits, std::size_t unit) const
  {
    Cube result{ offset, level + bits };
    for (std::size_t axis = 0; axis < 3; ++axis)
    {
      const std::size_t at = unit >> axis * static_cast<std::size_t>(bits) & ((1U << bits) - 1);
      result.offset[axis] = static_cast<std::uint16_t>(
        result.offset[axis] + static_cast<std::int64_t>(at) * result.size());
    }
    return result;
  }
};

// The lower or upper half of a box that has an offset and levels as LocalBox has; all else stays.
template <class BoxInGlobal>
BoxInGlobal halfOf(BoxInGlobal box, unsigned axis, bool upper)
{
  ++box.level[axis];
  box.offset[axis] =
    static_cast<std::uint16_t>(box.offset[axis] + (upper ? FinePerBox >> box.level[axis] : 0));
  return box;
}

}
