// SPDX-License-Identifier: BSD-3-Clause
#include "Boxes/FewestBoxes.h"

#include <algorithm>
#include <limits>

namespace cartesian
{

namespace
{

constexpr std::uint8_t bit(BoxStatus status)
{
  return static_cast<std::uint8_t>(1u << static_cast<unsigned>(status));
}

}

FewestBoxes::DyadicBox FewestBoxes::half(const DyadicBox& box, int axis, int which)
{
  DyadicBox result = box;
  ++result.level[axis];
  result.position[axis] = 2 * box.position[axis] + which;
  return result;
}

std::size_t FewestBoxes::index(const DyadicBox& box) const
{
  std::size_t result = 0;
  for (std::size_t axis = 0; axis < 3; ++axis)
  {
    const int before = (1 << box.level[axis]) - 1; // larger boxes
    result += stride_[axis] * static_cast<std::size_t>(before + box.position[axis]);
  }
  return result;
}

std::size_t FewestBoxes::lowerHalf(const DyadicBox& box, std::size_t here, std::size_t axis) const
{
  return here +
    stride_[axis] * static_cast<std::size_t>((1 << box.level[axis]) + box.position[axis]);
}

bool FewestBoxes::isLeaf(const DyadicBox& box, std::size_t here) const
{
  const auto& [x, y, z] = box.level;
  if (isotropic_ && (x != y || y != z))
  {
    return false;
  }
  const Content& content = content_[here];
  const int least = cube_.level + std::min({ x, y, z });
  const bool intersected = (content.statuses & bit(BoxStatus::Intersected)) != 0;
  return least >= content.forced &&
    (intersected ? least >= allowed_ : content.statuses == bit(BoxStatus::Inside));
}

bool FewestBoxes::maySplit(const DyadicBox& box, std::size_t axis) const
{
  const auto& [x, y, z] = box.level;
  return box.level[axis] < bits_ && (!isotropic_ || box.level[axis] == std::min({ x, y, z }));
}

int FewestBoxes::cheapestSplit(const DyadicBox& box, std::size_t here, std::uint32_t& cost) const
{
  int best = -1;
  cost = std::numeric_limits<std::uint32_t>::max();
  for (std::size_t axis = 0; axis < 3; ++axis)
  {
    if (maySplit(box, axis))
    {
      const std::size_t lower = lowerHalf(box, here, axis);
      const std::uint32_t sum = cost_[lower] + cost_[lower + stride_[axis]];
      if (sum < cost)
      {
        cost = sum;
        best = static_cast<int>(axis);
      }
    }
  }
  return best;
}

void FewestBoxes::evaluate(const DyadicBox& box, std::size_t here)
{
  for (std::size_t axis = 0; axis < 3; ++axis)
  {
    if (box.level[axis] < bits_)
    {
      const Content& lower = content_[lowerHalf(box, here, axis)];
      const Content& upper = content_[lowerHalf(box, here, axis) + stride_[axis]];
      content_[here] = { static_cast<std::uint8_t>(lower.statuses | upper.statuses),
        std::max(lower.forced, upper.forced) };
      break;
    }
  }
  if (content_[here].statuses == bit(BoxStatus::Outside))
  {
    cost_[here] = 0;
  }
  else if (isLeaf(box, here) || isUnit(box))
  {
    cost_[here] = 1;
  }
  else
  {
    cheapestSplit(box, here, cost_[here]);
  }
}

// Calls visit(box, index) for the dyadic boxes of these levels, x fastest.
template <class Visitor>
void FewestBoxes::forEachDyadicBox(const std::array<int, 3>& level, Visitor&& visit) const
{
  DyadicBox box{ level, {} };
  for (box.position[2] = 0; box.position[2] < 1 << level[2]; ++box.position[2])
  {
    for (box.position[1] = 0; box.position[1] < 1 << level[1]; ++box.position[1])
    {
      box.position[0] = 0;
      std::size_t here = index(box);
      for (; box.position[0] < 1 << level[0]; ++box.position[0])
      {
        visit(box, here++);
      }
    }
  }
}

std::uint32_t FewestBoxes::search(const Cube& cube, int bits, int allowed,
  const std::vector<BoxStatus>& units, const std::vector<std::uint8_t>& forced)
{
  cube_ = cube;
  bits_ = bits;
  allowed_ = allowed;
  const std::size_t along = (std::size_t(2) << bits) - 1;
  stride_ = { 1, along, along * along };
  cost_.resize(along * along * along);
  content_.resize(cost_.size());
  std::size_t unit = 0;
  forEachDyadicBox({ bits, bits, bits }, [&](const DyadicBox&, std::size_t here) {
    content_[here] = { bit(units[unit]), forced[unit] };
    ++unit;
  });
  // Halves are deeper than the whole, so from the units up.
  std::array<int, 3> level{};
  for (level[2] = bits; level[2] >= 0; --level[2])
  {
    for (level[1] = bits; level[1] >= 0; --level[1])
    {
      for (level[0] = bits; level[0] >= 0; --level[0])
      {
        forEachDyadicBox(
          level, [&](const DyadicBox& box, std::size_t here) { evaluate(box, here); });
      }
    }
  }
  return cost_[index(whole())];
}

void FewestBoxes::collect(std::vector<LocalBox>& boxes, std::vector<std::uint32_t>& units) const
{
  collect(whole(), boxes, units);
}

void FewestBoxes::collect(
  const DyadicBox& box, std::vector<LocalBox>& boxes, std::vector<std::uint32_t>& units) const
{
  const std::size_t here = index(box);
  const std::uint8_t content = content_[here].statuses;
  if (content == bit(BoxStatus::Outside))
  {
    return;
  }
  if (isLeaf(box, here))
  {
    LocalBox leaf;
    for (std::size_t axis = 0; axis < 3; ++axis)
    {
      const int level = cube_.level + box.level[axis];
      leaf.level[axis] = static_cast<std::uint8_t>(level);
      leaf.offset[axis] =
        static_cast<std::uint16_t>(cube_.offset[axis] + box.position[axis] * (FinePerBox >> level));
    }
    leaf.status = content == bit(BoxStatus::Inside) ? BoxStatus::Inside : BoxStatus::Intersected;
    leaf.corners = AllCorners;
    boxes.push_back(leaf);
    return;
  }
  if (isUnit(box))
  {
    const auto& [x, y, z] = box.position;
    units.push_back(static_cast<std::uint32_t>(x | y << bits_ | z << 2 * bits_));
    return;
  }
  std::uint32_t cost = 0;
  const int axis = cheapestSplit(box, here, cost);
  collect(half(box, axis, 0), boxes, units);
  collect(half(box, axis, 1), boxes, units);
}

}
