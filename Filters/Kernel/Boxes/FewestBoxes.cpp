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
  const std::size_t along = (std::size_t(2) << depth_) - 1;
  std::size_t result = 0;
  for (int axis = 2; axis >= 0; --axis)
  {
    const int level = box.level[axis];
    result = result * along + static_cast<std::size_t>((1 << level) - 1 + box.position[axis]);
  }
  return result;
}

bool FewestBoxes::isLeaf(const DyadicBox& box) const
{
  const auto& [x, y, z] = box.level;
  const Content& content = content_[index(box)];
  const int least = std::min({ x, y, z });
  const bool intersected = (content.statuses & bit(BoxStatus::Intersected)) != 0;
  return least >= content.forced &&
    (intersected ? least >= allowed_ : content.statuses == bit(BoxStatus::Inside));
}

int FewestBoxes::cheapestSplit(const DyadicBox& box, std::uint32_t& cost) const
{
  int best = -1;
  cost = std::numeric_limits<std::uint32_t>::max();
  for (int axis = 0; axis < 3; ++axis)
  {
    if (box.level[axis] < depth_)
    {
      const std::uint32_t sum = cost_[index(half(box, axis, 0))] + cost_[index(half(box, axis, 1))];
      if (sum < cost)
      {
        cost = sum;
        best = axis;
      }
    }
  }
  return best;
}

void FewestBoxes::evaluate(const DyadicBox& box)
{
  const std::size_t here = index(box);
  for (int axis = 0; axis < 3; ++axis)
  {
    if (box.level[axis] < depth_)
    {
      const Content& lower = content_[index(half(box, axis, 0))];
      const Content& upper = content_[index(half(box, axis, 1))];
      content_[here] = { static_cast<std::uint8_t>(lower.statuses | upper.statuses),
        std::max(lower.forced, upper.forced) };
      break;
    }
  }
  if (content_[here].statuses == bit(BoxStatus::Outside))
  {
    cost_[here] = 0;
  }
  else if (isLeaf(box))
  {
    cost_[here] = 1;
  }
  else
  {
    cheapestSplit(box, cost_[here]);
  }
}

// Calls visit(box) for the dyadic boxes of these levels, x fastest.
template <class Visitor>
void FewestBoxes::forEachDyadicBox(const std::array<int, 3>& level, Visitor&& visit)
{
  DyadicBox box{ level, {} };
  for (box.position[2] = 0; box.position[2] < 1 << level[2]; ++box.position[2])
  {
    for (box.position[1] = 0; box.position[1] < 1 << level[1]; ++box.position[1])
    {
      for (box.position[0] = 0; box.position[0] < 1 << level[0]; ++box.position[0])
      {
        visit(box);
      }
    }
  }
}

std::uint32_t FewestBoxes::search(int depth, int allowed, const std::vector<BoxStatus>& units,
  const std::vector<std::uint8_t>& forced)
{
  depth_ = depth;
  allowed_ = allowed;
  const std::size_t along = (std::size_t(2) << depth) - 1;
  cost_.resize(along * along * along);
  content_.resize(cost_.size());
  std::size_t unit = 0;
  forEachDyadicBox({ depth, depth, depth }, [&](const DyadicBox& box) {
    content_[index(box)] = { bit(units[unit]), forced[unit] };
    ++unit;
  });
  // Halves are deeper than the whole, so from the units up.
  std::array<int, 3> level{};
  for (level[2] = depth; level[2] >= 0; --level[2])
  {
    for (level[1] = depth; level[1] >= 0; --level[1])
    {
      for (level[0] = depth; level[0] >= 0; --level[0])
      {
        forEachDyadicBox(level, [&](const DyadicBox& box) { evaluate(box); });
      }
    }
  }
  return cost_[index(whole())];
}

void FewestBoxes::collect(std::vector<LocalBox>& boxes) const
{
  collect(whole(), boxes);
}

void FewestBoxes::collect(const DyadicBox& box, std::vector<LocalBox>& boxes) const
{
  const std::uint8_t content = content_[index(box)].statuses;
  if (content == bit(BoxStatus::Outside))
  {
    return;
  }
  if (isLeaf(box))
  {
    LocalBox leaf;
    for (int axis = 0; axis < 3; ++axis)
    {
      leaf.level[axis] = static_cast<std::uint8_t>(box.level[axis]);
      leaf.offset[axis] =
        static_cast<std::uint16_t>(box.position[axis] * (FinePerBox >> box.level[axis]));
    }
    leaf.status = content == bit(BoxStatus::Inside) ? BoxStatus::Inside : BoxStatus::Intersected;
    leaf.corners = AllCorners;
    boxes.push_back(leaf);
    return;
  }
  std::uint32_t cost = 0;
  const int axis = cheapestSplit(box, cost);
  collect(half(box, axis, 0), boxes);
  collect(half(box, axis, 1), boxes);
}

}
